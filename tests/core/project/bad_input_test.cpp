// Every kind of bad input: its message, its place in the project and in the file.
#include <gtest/gtest.h>

#include "tests/core/project/test_kinds.h"

namespace covaria::test::bad_input_test {

namespace {

struct BadInput {
    const char* name;
    const char* from;  // in whole_project
    const char* to;
    const char* message;  // part of the expected one
    const char* path;
    int line;
};

std::ostream& operator<<(std::ostream& out, const BadInput& input) {
    return out << input.name;
}

// clang-format off
const BadInput bad_inputs[] = {
    // syntax
    {"MissingComma", "\"schemaVersion\": 2,", "\"schemaVersion\": 2", "',' or '}' is expected here", "", 4},
    {"MissingColon", "\"title\":", "\"title\"", "':' is expected after the key 'title'", "", 4},
    {"UnquotedKey", "\"title\":", "title:", "a key in double quotes is expected here (column 3)", "", 4},
    {"TrailingComma", "196000, 0.066, true]", "196000, 0.066, ]", "a value is expected here", "", 25},
    {"UnclosedText", "\"certificate 7\",\n      \"setup\"", "\"certificate 7,\n      \"setup\"", "not closed by a double quote", "", 11},
    {"NotANumberToken", "196000", "NaN", "'NaN' is not a number", "", 25},
    {"InfinityToken", "196000", "-Infinity", "'-Infinity' is not a number", "", 25},
    {"NumberLeadingZero", "196000", "0196", "'0196' is not a value", "", 25},
    {"SingleWord", "196000", "wide", "'wide' is not a value", "", 25},
    {"HugeNumber", "196000", "1e999", "\'1e999\' is too large a number", "", 25},
    {"BadEscape", "first line", "first \\x line", "wrong \\ sequence", "", 5},
    {"TwiceTheSameKey", "\"notes\": \"certificate 7\",", "\"name\": \"again\",", "'name' is given twice", "/assets/0/name", 11},
    {"TextAfterTheEnd", "    }\n  ]\n}\n", "    }\n  ]\n}\n}", "nothing may follow its closing '}'", "", 91},
    // document
    {"OtherFormat", "\"format\": \"covaria\"", "\"format\": \"other\"", "not a project of Covaria", "/format", 2},
    {"NoVersion", "  \"schemaVersion\": 2,\n", "", "'schemaVersion' is missing", "", 1},
    {"TextVersion", "\"schemaVersion\": 2", "\"schemaVersion\": \"2\"", "must be a whole number", "/schemaVersion", 3},
    {"UnknownTopKey", "\"title\"", "\"titel\"", "there is no 'titel' in the project (did you mean 'title'?)", "/titel", 4},
    {"MissingTitle", "\"title\"", "\"titel\"", "'title' is missing in the project", "/title", 1},
    {"AssetsNotAList", "\"notes\": \"first line\\nsecond line\"", "\"notes\": 7", "'notes' must be a text in quotes, not the number 7", "/notes", 5},
    // assets
    {"UnknownKind", "\"kind\": \"block\"", "\"kind\": \"blok\"", "there is no kind of asset 'blok' (did you mean 'block'?); known are 'block' and 'clamp'", "/assets/0/kind", 9},
    {"RepeatedId", "\"id\": \"clamp_2\"", "\"id\": \"block-1\"", "another one has the same id", "/assets/1/id", 37},
    {"MalformedId", "\"id\": \"clamp_2\"", "\"id\": \"clamp 2\"", "must be made of letters, digits", "/assets/1/id", 37},
    {"MissingId", "\"id\": \"clamp_2\",", "", "'id' is missing in an asset", "/assets/1/id", 36},
    {"UnknownAssetKey", "\"notes\": \"certificate 7\"", "\"note\": \"certificate 7\"", "there is no 'note' in an asset (did you mean 'notes'?)", "/assets/0/note", 11},
    // fields
    {"UnknownField", "\"rounds\"", "\"round\"", "there is no 'round' in this set-up (did you mean 'rounds'?)", "/assets/0/setup/round", 15},
    {"NoUnit", "{\"value\": 688, \"unit\": \"mm\"}", "688", "'length of the block' is a length; its unit is missing: write {\"value\": 688, \"unit\": \"mm\"}", "/assets/0/setup/length", 13},
    {"WrongUnit", "{\"value\": 688, \"unit\": \"mm\"}", "{\"value\": 3, \"unit\": \"N\"}", "'length of the block' is a length; '3 N' is a force", "/assets/0/setup/length", 13},
    {"UnknownUnit", "\"unit\": \"K\"", "\"unit\": \"kelvins\"", "kelvins", "/assets/0/setup/temperature_deviation/unit", 14},
    {"DifferenceInCelsius", "\"unit\": \"K\"", "\"unit\": \"degC\"", "is a difference of temperatures: give it in K", "/assets/0/setup/temperature_deviation", 14},
    {"MissingValue", "{\"value\": 688, \"unit\"", "{\"unit\"", "'value' is missing", "/assets/0/setup/length/value", 13},
    {"OutOfRange", "{\"value\": 688, \"unit\": \"mm\"}", "{\"value\": 0, \"unit\": \"mm\"}", "'length of the block' must be greater than 0 mm and at most 10000 mm; it is 0 mm", "/assets/0/setup/length", 13},
    {"InfiniteLength", "{\"value\": 688, \"unit\": \"mm\"}", "{\"value\": null, \"unit\": \"mm\"}", "must be a finite number; it is infinity", "/assets/0/setup/length", 13},
    {"NotWhole", "\"rounds\": 5", "\"rounds\": 2.5", "'number of rounds' must be a whole number; it is 2.5", "/assets/0/setup/rounds", 15},
    {"IntegerOutOfRange", "\"rounds\": 5", "\"rounds\": 101", "'number of rounds' must be between 1 and 100; it is 101", "/assets/0/setup/rounds", 15},
    {"WrongChoice", "\"material\": \"aluminium\"", "\"material\": \"aluminum\"", "'material' must be one of 'steel' and 'aluminium'; it is 'aluminum' (did you mean 'aluminium'?)", "/assets/0/setup/material", 17},
    {"TextAsFlag", "\"hardened\": true", "\"hardened\": \"true\"", "'hardened' must be true or false, not the text 'true': write true or false, without quotes", "/assets/0/setup/hardened", 19},
    {"NumberAsText", "\"remark\": \"\"", "\"remark\": 1", "'remark' must be a text in quotes, not the number 1", "/assets/0/setup/remark", 18},
    {"MissingHardness", "\"hardness\": {\"value\": 62.5, \"unit\": \"%\"},", "", "'hardness' must be given", "/assets/0/setup/hardness", 12},
    {"ShortPose", "[0, 0, 1175]", "[0, 0]", "'position' of 'pose of the block' must be a list of three numbers", "/assets/0/setup/pose/position", 21},
    {"PoseInForce", "\"lengthUnit\": \"mm\"", "\"lengthUnit\": \"N\"", "'pose of the block' is a length; '0 N' is a force", "/assets/0/setup/pose", 21},
    {"PoseWithoutUnit", ", \"angleUnit\": \"deg\"", "", "'angleUnit' is missing", "/assets/0/setup/pose/angleUnit", 21},
    // tables
    {"UnknownColumn", "\"y [um]\"", "\"yy [um]\"", "'points' has no column 'yy' (did you mean 'y'?)", "/assets/0/setup/points/columns/2", 23},
    {"ColumnTwice", "\"y [um]\"", "\"x [um]\"", "column 'x' of 'points' is given twice", "/assets/0/setup/points/columns/2", 23},
    {"MissingColumn", "\"y [um]\"", "\"x [um]\"", "column 'y [mm]' of 'points' is missing", "/assets/0/setup/points/columns", 23},
    {"ColumnWithoutUnit", "\"y [um]\"", "\"y\"", "its unit is missing: write \"y [mm]\"", "/assets/0/setup/points/columns/2", 23},
    {"ColumnInForce", "\"y [um]\"", "\"y [N]\"", "column 'y' of 'points' is a length; 'N' is the unit of a force", "/assets/0/setup/points/columns/2", 23},
    {"ColumnUnknownUnit", "\"y [um]\"", "\"y [furlongs]\"", "furlongs", "/assets/0/setup/points/columns/2", 23},
    {"TextColumnWithUnit", "\"name\", \"x [mm]\"", "\"name [mm]\", \"x [mm]\"", "has no unit", "/assets/0/setup/points/columns/0", 23},
    {"RowTooShort", "[\"b1\", -344, 196000, 0.066, true]", "[\"b1\", -344]", "row 1 of 'points' has 2 cells; there are 5 columns", "/assets/0/setup/points/rows/0", 25},
    {"RowNotAList", "[\"b1\", -344, 196000, 0.066, true]", "7", "must be a list in brackets, not the number 7", "/assets/0/setup/points/rows/0", 25},
    {"TextInNumberColumn", "\"b2\", 1e-07", "\"b2\", \"1e-07\"", "'x' in row 2 of 'points' must be a number, not the text '1e-07': write 1e-07, without quotes", "/assets/0/setup/points/rows/1/x", 26},
    {"CommaInNumberColumn", "\"b2\", 1e-07", "\"b2\", \"1,5\"", "'x' in row 2 of 'points' must be a number, not the text '1,5': write 1.5, without quotes", "/assets/0/setup/points/rows/1/x", 26},
    {"UnitInNumberColumn", "\"b2\", 1e-07", "\"b2\", \"1500 um\"", "'x' in row 2 of 'points' must be a number, not the text '1500 um': write 1.5, without quotes: the unit of the column is mm", "/assets/0/setup/points/rows/1/x", 26},
    {"ForceInNumberColumn", "\"b2\", 1e-07", "\"b2\", \"3 N\"", "'x' in row 2 of 'points' must be a number, not the text '3 N': write a number in mm, the unit of the column, without quotes", "/assets/0/setup/points/rows/1/x", 26},
    {"WordInNumberColumn", "\"b2\", 1e-07", "\"b2\", \"n/a\"", "'x' in row 2 of 'points' must be a number, not the text 'n/a': write a number without quotes, such as 0.25, or null where there is none", "/assets/0/setup/points/rows/1/x", 26},
    {"EmptyCell", "\"b2\", 1e-07", "\"b2\", null", "'x in row 2 of points' is empty", "/assets/0/setup/points/rows/1/x", 26},
    {"CellOutOfRange", "\"b2\", 1e-07", "\"b2\", 2000", "'x in row 2 of points' must be between -1000 mm and 1000 mm; it is 2000 mm", "/assets/0/setup/points/rows/1/x", 26},
    {"NegativeUncertainty", "0.066", "-0.066", "'u_p in row 1 of points' must be at least 0 um; it is -0.066 um", "/assets/0/setup/points/rows/0/u", 25},
    {"TableNotATable", "{\n          \"columns\": [\"point\", \"value [mm]\"],\n          \"rows\": []\n        }", "[]", "must be an object in braces, not a list", "/assets/0/setup/readings", 30},
    {"TableWithoutRows", "\"columns\": [\"point\", \"value [mm]\"],\n          \"rows\": []", "\"columns\": [\"point\"]", "it needs \"columns\" and \"rows\"", "/assets/0/setup/readings", 30},
    // analyses
    {"UnknownModel", "\"model\": \"sum\"", "\"model\": \"sums\"", "there is no measurement model 'sums' (did you mean 'sum'?)", "/analyses/0/model", 47},
    {"MissingReference", "\"block\": \"block-1\",", "\"block\": \"blok-1\",", "'block' refers to the asset 'blok-1', which does not exist (did you mean 'the block'?)", "/analyses/0/setup/block", 50},
    {"WrongCapability", "\"block\": \"block-1\",", "\"block\": \"clamp_2\",", "does not offer 'point-uncertainty'", "/analyses/0/setup/block", 50},
    {"ModelRefuses", "\"gain\": 2", "\"gain\": 0", "a gain of zero measures nothing", "/analyses/0/setup/gain", 52},
    {"UnknownSymbol", "\"symbol\": \"c\"", "\"symbol\": \"c_alibration\", \"held\": true", "the model has no input quantity 'c_alibration' (did you mean 'c.calibration'?)", "/analyses/0/inputs/1/symbol", 65},
    {"EditedTwice", "\"symbol\": \"c\"", "\"symbol\": \"a\"", "'a' is edited twice", "/analyses/0/inputs/1/symbol", 65},
    {"EstimateInForce", "\"value\": 12.5, \"unit\": \"mm\"", "\"value\": 12.5, \"unit\": \"N\"", "'a' is a length; '12.5 N' is a force", "/analyses/0/inputs/0/estimate", 57},
    {"ComponentInForce", "\"standard_deviation\": 3}, \"unit\": \"um\"", "\"standard_deviation\": 3}, \"unit\": \"N\"", "the unit 'N' of 'certificate' is the unit of a force", "/analyses/0/inputs/0/components/0/unit", 59},
    {"NegativeDeviation", "\"standard_deviation\": 3", "\"standard_deviation\": -3", "'certificate' of 'a': ", "/analyses/0/inputs/0/components/0/parameters", 59},
    {"UnknownDistribution", "\"distribution\": \"normal\"", "\"distribution\": \"normale\"", "there is no distribution 'normale' (did you mean 'normal'?)", "/analyses/0/inputs/0/components/0/distribution", 59},
    {"UnknownParameter", "\"standard_deviation\": 3", "\"deviation\": 3", "there is no 'deviation' in the parameters of 'normal'", "/analyses/0/inputs/0/components/0/parameters/deviation", 59},
    {"NegativeFreedom", "\"degreesOfFreedom\": 9", "\"degreesOfFreedom\": -9", "degrees of freedom must be greater than zero", "/analyses/0/inputs/0/components/1/degreesOfFreedom", 60},
    {"WrongType", "\"type\": \"A\"", "\"type\": \"C\"", "'type' must be one of 'A' and 'B'; it is 'C'", "/analyses/0/inputs/0/components/1/type", 60},
    {"WrongCombination", "\"arithmetic\"", "\"sum\"", "'combination' must be one of 'quadrature' and 'arithmetic'", "/analyses/0/inputs/1/combination", 65},
    {"ComponentEstimate", "{\"symbol\": \"b.calibration\"", "{\"combination\": \"quadrature\", \"symbol\": \"b.calibration\"", "is a component, not an input quantity", "/analyses/0/inputs/2/symbol", 66},
    {"UnknownComponent", "\"second\": \"b.calibration\"", "\"second\": \"b.calibratoin\"", "there is no component or quantity 'b.calibratoin' (did you mean 'b.calibration'?)", "/analyses/0/correlations/0/second", 69},
    {"SelfCorrelation", "\"second\": \"b.calibration\"", "\"second\": \"a.edit1\"", "cannot be correlated with itself", "/analyses/0/correlations/0/second", 69},
    {"CorrelationTooLarge", "\"coefficient\": 0.25", "\"coefficient\": 1.25", "must lie between -1 and 1; it is 1.25", "/analyses/0/correlations/0/coefficient", 69},
    {"UnknownMethod", "\"method\": \"adaptive\"", "\"method\": \"adaptiv\"", "'Method' must be one of 'first-order', 'monte-carlo' and 'adaptive'", "/analyses/0/options/method", 72},
    {"SeedAsNumber", "\"seed\": \"18446744073709551615\"", "\"seed\": 7", "'seed' must be a text in quotes, not the number 7", "/analyses/0/options/seed", 74},
    {"SeedTooLarge", "\"seed\": \"18446744073709551615\"", "\"seed\": \"18446744073709551616\"", "'Seed' must be a whole number from 0 to", "/analyses/0/options/seed", 74},
    {"FractionOfATrial", "\"trials\": 200000", "\"trials\": 0.5", "'Trials' must be a whole number", "/analyses/0/options/trials", 73},
    {"CertainCoverage", "\"coverageProbability\": 0.99", "\"coverageProbability\": 1", "coverage probability", "/analyses/0/options/coverageProbability", 75},
    {"NegativeTolerance", "\"tolerance\": 1e-07", "\"tolerance\": -1", "tolerance", "/analyses/0/options/tolerance", 80},
    {"UnknownOption", "\"secondOrder\"", "\"secondorder\"", "there is no 'secondorder' in 'options' (did you mean 'secondOrder'?)", "/analyses/0/options/secondorder", 77},
    {"UnknownOutput", "\"symbol\": \"z\"", "\"symbol\": \"zz\"", "the model has no output quantity 'zz' in 'lengths'", "/analyses/0/requirements/1", 86},
    {"TargetInForce", "{\"value\": 0.05, \"unit\": \"mm\"}", "{\"value\": 0.05, \"unit\": \"N\"}", "is a length; '0.05 N' is a force", "/analyses/0/requirements/0/targetUncertainty", 85},
    {"TargetOfZero", "{\"value\": 0.05, \"unit\": \"mm\"}", "{\"value\": 0, \"unit\": \"mm\"}", "must be greater than zero", "/analyses/0/requirements/0/targetUncertainty", 85},
};
// clang-format on

class BadInputTest : public testing::TestWithParam<BadInput> {};

}  // namespace

TEST_P(BadInputTest, IsNamedWithItsPlace) {
    const BadInput& input = GetParam();
    const LoadedProject loaded = parse(changed(input.from, input.to));
    const Problem problem = problem_with(loaded.problems, input.message);
    EXPECT_EQ(problem.severity, Severity::error) << problem.message.english();
    EXPECT_EQ(problem.path, input.path);
    EXPECT_EQ(problem.line, input.line);
    EXPECT_EQ(problem.file, "test.covaria");
}

/// A message without the words of the program has only symbols and names in quotes left.
TEST_P(BadInputTest, IsSaidInTheLanguageOfTheWindow) {
    const LoadedProject loaded = parse(changed(GetParam().from, GetParam().to));
    const Problem problem = problem_with(loaded.problems, GetParam().message);
    const std::string without_words = problem.message.in([](const std::string& words) {
        std::string placeholders;
        for (std::size_t i = 0; i + 1 < words.size(); ++i)
            if (words[i] == '%') placeholders += words.substr(i, 2) + "|";
        return placeholders;
    });
    for (const char* word : {" is ", " must ", " the ", " not ", " of ", " no ", " has "})
        EXPECT_EQ(without_words.find(word), std::string::npos)
            << problem.message << " leaves " << without_words;
}

INSTANTIATE_TEST_SUITE_P(Every, BadInputTest, testing::ValuesIn(bad_inputs),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(BadInput, AllProblemsAreCollected) {
    std::string text = changed("\"rounds\": 5", "\"rounds\": 101");
    text.replace(text.find("\"gain\": 2"), 9, "\"gian\": 2");
    text.replace(text.find("\"mm\""), 4, "\"N\"");
    const LoadedProject loaded = parse(text);
    EXPECT_NE(problem_with(loaded.problems, "number of rounds").line, -1);
    EXPECT_NE(problem_with(loaded.problems, "'gian'").line, -1);
    EXPECT_NE(problem_with(loaded.problems, "is a force").line, -1);
}

TEST(BadInput, WhatCannotBeReadIsNotAlsoMissing) {
    const LoadedProject loaded = parse(changed("\"b2\", 1e-07", "\"b2\", \"1e-07\""));
    ASSERT_GE(loaded.problems.items().size(), 1u);
    for (const Problem& problem : loaded.problems.items())
        EXPECT_EQ(problem.message.english().find("is empty"), std::string::npos) << problem.message.english();
}

TEST(BadInput, MatrixThatIsNoCorrelationMatrix) {
    const LoadedProject loaded = parse(
        changed("{\"first\": \"a.edit1\", \"second\": \"b.calibration\", \"coefficient\": 0.25}",
                "{\"first\": \"temperature\", \"second\": \"b.calibration\", \"coefficient\": 0.9},\n"
                "{\"first\": \"temperature\", \"second\": \"c.calibration\", \"coefficient\": 0.9},\n"
                "{\"first\": \"b.calibration\", \"second\": \"c.calibration\", \"coefficient\": -0.9}"));
    ASSERT_EQ(loaded.problems.items().size(), 1u);
    const Problem problem = loaded.problems.items().front();
    EXPECT_EQ(problem.path, "/analyses/0/correlations");
    EXPECT_NE(problem.message.english().find("contradict each other"), std::string::npos)
        << problem.message.english();
}

TEST(BadInput, ACorrelationIsGivenOnce) {
    const std::string one = "{\"first\": \"a.edit1\", \"second\": \"b.calibration\", \"coefficient\": 0.25}";
    const std::string again = "{\"first\": \"b.calibration\", \"second\": \"a.edit1\", \"coefficient\": 0.5}";
    const LoadedProject loaded = parse(changed(one, one + ",\n" + again));
    EXPECT_EQ(problem_with(loaded.problems, "is given twice").path, "/analyses/0/correlations/1");
}

TEST(BadInput, MissingFileAndFolder) {
    const LoadedProject none = load_project("/no/such/file.covaria");
    EXPECT_EQ(problem_with(none.problems, "No such file").file, "/no/such/file.covaria");
    const LoadedProject folder = load_project(COVARIA_SOURCE_DIR);
    EXPECT_EQ(problem_with(folder.problems, "cannot be read").severity, Severity::error);
}

TEST(BadInput, EmptyAndTruncatedFiles) {
    EXPECT_EQ(problem_with(parse("").problems, "the file is empty").severity, Severity::error);
    const std::string text = whole_project;
    const LoadedProject loaded = parse(text.substr(0, text.find("\"clamp_2\"")));
    const Problem problem = problem_with(loaded.problems, "the file is truncated");
    EXPECT_EQ(problem.line, 37);
    EXPECT_EQ(loaded.problems.items().size(), 1u);
}

TEST(BadInput, DeepNestingIsRefused) {
    const LoadedProject loaded = parse(std::string(100000, '['));
    EXPECT_EQ(problem_with(loaded.problems, "nested too deeply").severity, Severity::error);
}

TEST(BadInput, AProjectThatWouldTakeTheMemoryIsRefused) {
    const auto file = fresh_folder("too-large") / "p.covaria";
    put_bytes(file, std::string(largest_project + 1, ' '));
    const LoadedProject loaded = load_project(file);
    const Problem problem = problem_with(loaded.problems, "put its long tables into CSV files");
    EXPECT_EQ(problem.file, file.string());
    EXPECT_EQ(problem.line, 1);
}

}  // namespace covaria::test::bad_input_test
