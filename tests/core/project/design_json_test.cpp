// Designs in project files: bytes, every problem with its place, tables to choose from.
#include <gtest/gtest.h>

#include "core/project/design_check.h"
#include "core/project/project_text.h"
#include "tests/core/made.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::design_json_test {

namespace {

const std::string last_requirement = R"({"group": "lengths", "symbol": "z"}
      ])";

std::string with_designs(const std::string& designs) {
    return changed(last_requirement, last_requirement + ",\n      \"designs\": " + designs);
}

const char* const canonical = R"([
        {
          "id": "d-1",
          "name": "gain and points",
          "variables": [
            {"target": "/setup/gain", "from": 0.5, "to": 2, "tolerance": 0.01},
            {"asset": "block-1", "target": "/setup/length", "change": "added", "from": -10, "to": 10, "unit": "um"}
          ],
          "choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 2, "fixed": [2]},
          "outputs": [
            {"group": "lengths", "symbol": "z"}
          ],
          "objective": "mean",
          "leastDistance": {"value": 0.5, "unit": "m"},
          "keepOut": [
            {"name": "pillar", "from": [0, 0, 0], "to": [1, 2, 3], "unit": "m"}
          ],
          "hiddenBy": [
            {"from": [-1, 0, 0], "to": [1, 2, 3], "unit": "mm"}
          ],
          "starts": 5,
          "seed": "18446744073709551615",
          "mostEvaluations": 500,
          "trials": 1000
        },
        {
          "id": "d-2",
          "variables": [
            {"target": "/inputs/a/components", "change": "factor", "from": 0.1, "to": 1}
          ]
        },
        {
          "id": "d-3",
          "choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 3, "prices": [120, 80.5, 0]},
          "objective": "cost"
        }
      ])";

struct BadDesign {
    const char* name;
    const char* design;  // its members
    const char* message;
    const char* path;  // below /analyses/0/designs/0
};
std::ostream& operator<<(std::ostream& out, const BadDesign& bad) {
    return out << bad.name;
}

// clang-format off
const BadDesign bad_designs[] = {
    {"UnknownKey", R"("variable": [])", "there is no 'variable' in a design", "/variable"},
    {"NothingToChoose", R"("starts": 3)", "needs 'variables', a table", ""},
    {"LeastOfOne", R"("reductions": [{"target": "/setup/gain", "price": 1, "least": 1}])", "between 0 and 1", "/reductions/0/least"},
    {"NegativePrice", R"("reductions": [{"target": "/setup/gain", "price": -1}])", "must not be negative", "/reductions/0/price"},
    {"ReducedTwice", R"("reductions": [{"target": "/setup/gain", "price": 1}, {"target": "/setup/gain", "price": 2}])", "reduced twice", "/reductions/1/target"},
    {"ReductionAndVariable", R"("variables": [{"target": "/setup/gain", "from": 1, "to": 2}], "reductions": [{"target": "/setup/gain", "price": 1}])", "a design of their own", "/reductions"},
    {"UnknownTarget", R"("variables": [{"target": "/setup/gian", "from": 1, "to": 2}])", "did you mean 'gain'?", "/variables/0/target"},
    {"EqualEnds", R"("variables": [{"target": "/setup/gain", "from": 1, "to": 1}])", "two different numbers", "/variables/0/to"},
    {"NumberOfValues", R"("variables": [{"target": "/setup/gain", "from": 1, "to": 2, "values": 3}])", "there is no 'values' in a variable", "/variables/0/values"},
    {"NegativeTolerance", R"("variables": [{"target": "/setup/gain", "from": 1, "to": 2, "tolerance": -1}])", "must not be negative", "/variables/0/tolerance"},
    {"WholeNumber", R"("variables": [{"asset": "block-1", "target": "/setup/rounds", "from": 3, "to": 6}])", "takes whole numbers", "/variables/0/target"},
    {"TwiceTheSame", R"("variables": [{"target": "/setup/gain", "from": 1, "to": 2}, {"target": "/setup/gain", "from": 1, "to": 2}])", "chosen by two variables", "/variables/1/target"},
    {"NoTable", R"("choose": {"table": "/setup/points", "keep": 2})", "is written as", "/choose/table"},
    {"UnknownTable", R"("choose": {"asset": "block-1", "table": "/setup/point/rows", "keep": 2})", "has no table 'point' (did you mean 'points'?)", "/choose/table"},
    {"UnknownAsset", R"("choose": {"asset": "block-9", "table": "/setup/points/rows", "keep": 2})", "there is no asset 'block-9'", "/choose/asset"},
    {"KeepTooMany", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 4})", "of 3 rows", "/choose/keep"},
    {"KeepNothing", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 0})", "of 3 rows", "/choose/keep"},
    {"KeepHalf", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 1.5})", "must be a whole number", "/choose/keep"},
    {"TooFewPrices", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 2, "prices": [1, 2]})", "one price for all rows, or one for each of the 3; there are 2", "/choose/prices"},
    {"NegativeRowPrice", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 2, "prices": [1, 2, -1]})", "must not be negative", "/choose/prices/2"},
    {"CostWithoutPrices", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 2}, "objective": "cost")", "of rows with 'prices'", "/objective"},
    {"CostOfVariables", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 2, "prices": [1]}, "variables": [{"target": "/setup/gain", "from": 1, "to": 2}], "objective": "cost")", "and no variables", "/objective"},
    {"FixedTooFar", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 2, "fixed": [3]})", "there are 3 rows", "/choose/fixed/0"},
    {"FixedTwice", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 2, "fixed": [1, 1]})", "is fixed twice", "/choose/fixed/1"},
    {"FixedNoNumber", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 2, "fixed": ["b"]})", "a number is needed here", "/choose/fixed/0"},
    {"NoSuchFile", R"("choose": {"asset": "block-1", "table": "/setup/points/rows", "keep": 2, "candidates": "none.csv"})", "none.csv", "/choose/candidates"},
    {"UnknownOutput", R"("variables": [{"target": "/setup/gain", "from": 1, "to": 2}], "outputs": [{"symbol": "w"}])", "no output quantity", "/outputs/0"},
    {"Objective", R"("objective": "smallest")", "'objective' must be one of", "/objective"},
    {"DistanceInNewton", R"("leastDistance": {"value": 1, "unit": "N"})", "is a force", "/leastDistance"},
    {"NoDistance", R"("leastDistance": {"value": 0, "unit": "mm"})", "greater than zero", "/leastDistance"},
    {"FlatBox", R"("keepOut": [{"from": [0, 0, 0], "to": [1, 0, 1], "unit": "mm"}])", "must be greater than", "/keepOut/0/to"},
    {"TwoCoordinates", R"("hiddenBy": [{"from": [0, 0], "to": [1, 1, 1], "unit": "mm"}])", "must be three numbers", "/hiddenBy/0/from"},
    {"BoxWithoutUnit", R"("hiddenBy": [{"from": [0, 0, 0], "to": [1, 1, 1]}])", "'unit' is missing", "/hiddenBy/0/unit"},
    {"NoStart", R"("starts": 0)", "there are 1 to", "/starts"},
    {"SeedAsWord", R"("seed": "one")", "'seed' must be", "/seed"},
    {"NoEvaluation", R"("mostEvaluations": 0)", "at least one evaluation", "/mostEvaluations"},
    {"OneTrial", R"("trials": 1)", "at least two trials", "/trials"},
};
// clang-format on

class BadDesigns : public testing::TestWithParam<BadDesign> {};

}  // namespace

TEST(DesignJson, ComesBackByteForByte) {
    const LoadedProject loaded = parse(with_designs(canonical));
    for (const Problem& problem : loaded.problems.items())
        ADD_FAILURE() << problem.path << ": " << problem.message.english();
    EXPECT_EQ(project_text(loaded.project), with_designs(canonical));
    const std::vector<Design>& designs = loaded.project.analyses[0].designs;
    ASSERT_EQ(designs.size(), 3u);
    EXPECT_EQ(designs[2].choose->price_of({0, 1}), 200.5);
    EXPECT_EQ(designs[0].variables[0].tolerance, 0.01);
    EXPECT_EQ(designs[0].choose->fixed, std::vector<std::size_t>{2});
    EXPECT_EQ(designs[0].objective, DesignObjective::mean);
    EXPECT_EQ(designs[0].keep_out[0].to[2], 3.0);
    EXPECT_EQ(designs[0].seed, 18446744073709551615u);
}

TEST(DesignJson, ChangesNoNumber) {
    const Project without = parse(whole_project).project, with = parse(with_designs(canonical)).project;
    EXPECT_EQ(fingerprint(without), fingerprint(with));
    EXPECT_TRUE(same_numbers(without, with));
    Problems problems;
    EXPECT_EQ(made_analysis(without, "sum-1", problems)->fingerprint(),
              made_analysis(with, "sum-1", problems)->fingerprint());
}

TEST(DesignJson, TheSameIdTwiceIsRefused) {
    const std::string one = R"({"id": "d", "variables": [{"target": "/setup/gain", "from": 1, "to": 2}]})";
    const LoadedProject loaded = parse(with_designs("[" + one + ", " + one + "]"));
    EXPECT_EQ(problem_with(loaded.problems, "another design has the same id").path,
              "/analyses/0/designs/1/id");
}

TEST_P(BadDesigns, AreSaidWithTheirPlace) {
    const LoadedProject loaded =
        parse(with_designs(std::string("[{\"id\": \"d\", ") + GetParam().design + "}]"));
    const Problem problem = problem_with(loaded.problems, GetParam().message);
    EXPECT_EQ(problem.path, std::string("/analyses/0/designs/0") + GetParam().path)
        << problem.message.english();
    EXPECT_EQ(problem.severity, Severity::error);
}
INSTANTIATE_TEST_SUITE_P(All, BadDesigns, testing::ValuesIn(bad_designs),
                         [](const auto& design) { return std::string(design.param.name); });

TEST(DesignTable, HasTheCandidatesOfAFileBehindItsRows) {
    Project project = parse(whole_project).project;
    project.directory = fresh_folder("candidates");
    put_bytes(project.directory / "more.csv", "name,x [um],y [mm],u [mm],used\nn1,1000,2,0.001,true\n");
    Problems problems;
    const auto table = find_design_table(
        project, project.analyses[0],
        {.asset = "block-1", .table = "/setup/points/rows", .keep = 1, .candidates = "more.csv"}, problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    ASSERT_TRUE(table);
    EXPECT_EQ(table->present, 3u);
    ASSERT_EQ(table->rows.rows.size(), 4u);
    EXPECT_EQ(row_words(table->rows, 3), "n1");
    EXPECT_EQ(std::get<double>(table->rows.rows[3][1]), 1.0);  // in the unit of the table, mm
}

}  // namespace covaria::test::design_json_test
