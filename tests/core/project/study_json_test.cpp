// Studies in project files: bytes, every problem with its place, targets and what they change.
#include <gtest/gtest.h>

#include "core/project/project_text.h"
#include "core/project/study_target.h"
#include "tests/core/made.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::study_json_test {

namespace {

const std::string last_requirement = R"({"group": "lengths", "symbol": "z"}
      ])";

std::string with_studies(const std::string& studies) {
    return changed(last_requirement, last_requirement + ",\n      \"studies\": " + studies);
}

std::string with_axis(const std::string& axis) {
    return with_studies("[{\"id\": \"s\", \"axes\": [" + axis + "]}]");
}

const char* const canonical = R"([
        {
          "id": "s-1",
          "name": "gain and length",
          "axes": [
            {"target": "/setup/gain", "from": 0.5, "to": 2, "values": 4, "spacing": "logarithmic"},
            {"asset": "block-1", "target": "/setup/length", "change": "added", "from": -10, "to": 10, "unit": "um", "values": 3}
          ],
          "outputs": [
            {"group": "lengths", "symbol": "z"}
          ],
          "method": "monte-carlo",
          "trials": 5000
        },
        {
          "id": "s-2",
          "axes": [
            {"target": "/inputs/a/components", "change": "factor", "from": 0, "to": 2, "values": 11}
          ]
        }
      ])";

struct BadStudy {
    const char* name;
    const char* axis;
    const char* message;
    const char* path;  // below /analyses/0/studies/0
};
std::ostream& operator<<(std::ostream& out, const BadStudy& bad) {
    return out << bad.name;
}

// clang-format off
const BadStudy bad_studies[] = {
    {"UnknownKey", R"({"target": "/setup/gain", "from": 1, "to": 2, "step": 1})", "there is no 'step' in an axis of a study", "/axes/0/step"},
    {"NoTarget", R"({"from": 1, "to": 2})", "'target' is missing", "/axes/0/target"},
    {"NoEnd", R"({"target": "/setup/gain", "from": 1})", "'to' is missing", "/axes/0/to"},
    {"NotAPointer", R"({"target": "gain", "from": 1, "to": 2})", "a target is written as", "/axes/0/target"},
    {"UnknownField", R"({"target": "/setup/gian", "from": 1, "to": 2})", "has no field 'gian' (did you mean 'gain'?)", "/axes/0/target"},
    {"NotANumber", R"({"target": "/setup/block", "from": 1, "to": 2})", "'block' is not a number", "/axes/0/target"},
    {"UnknownAsset", R"({"asset": "block-7", "target": "/setup/length", "from": 1, "to": 2})", "there is no asset 'block-7'", "/axes/0/asset"},
    {"UnknownSymbol", R"({"target": "/inputs/q/estimate", "from": 1, "to": 2})", "no input quantity 'q'", "/axes/0/target"},
    {"UnknownComponent", R"({"target": "/components/temperatur", "change": "factor", "from": 1, "to": 2})", "no component 'temperatur' (did you mean 'temperature'?)", "/axes/0/target"},
    {"InputOfAnAsset", R"({"asset": "block-1", "target": "/inputs/a/estimate", "from": 1, "to": 2})", "only numbers of the set-up of an asset", "/axes/0/target"},
    {"ValueOfAnUncertainty", R"({"target": "/inputs/a/components", "from": 1, "to": 2})", "by a factor only", "/axes/0/change"},
    {"NegativeFactor", R"({"target": "/inputs/a/components", "change": "factor", "from": -1, "to": 2})", "must not be negative", "/axes/0/from"},
    {"WrongUnit", R"({"target": "/inputs/a/estimate", "from": 1, "to": 2, "unit": "N"})", "is a length; '1 N' is a force", "/axes/0/unit"},
    {"NoUnit", R"({"asset": "block-1", "target": "/setup/length", "from": 1, "to": 2})", "is a length; '1' has no unit", "/axes/0/unit"},
    {"FactorWithUnit", R"({"asset": "block-1", "target": "/setup/length", "change": "factor", "from": 1, "to": 2, "unit": "mm"})", "a factor has no unit", "/axes/0/unit"},
    {"RowTooFar", R"({"asset": "block-1", "target": "/setup/points/rows/3/x", "from": 1, "to": 2, "unit": "mm"})", "has 3 rows", "/axes/0/target"},
    {"EmptyCell", R"({"asset": "block-1", "target": "/setup/points/rows/2/u", "change": "factor", "from": 1, "to": 2})", "the cell is empty", "/axes/0/target"},
    {"NoSuchColumn", R"({"asset": "block-1", "target": "/setup/points/columns/w", "change": "factor", "from": 1, "to": 2})", "no column 'w'", "/axes/0/target"},
    {"OneValue", R"({"target": "/setup/gain", "from": 1, "to": 2, "values": 1})", "at least two values", "/axes/0/values"},
    {"EqualEnds", R"({"target": "/setup/gain", "from": 1, "to": 1})", "two different numbers", "/axes/0/to"},
    {"LogarithmOfZero", R"({"target": "/setup/gain", "from": 0, "to": 1, "spacing": "logarithmic"})", "greater than zero", "/axes/0/spacing"},
    {"WrongSpacing", R"({"target": "/setup/gain", "from": 1, "to": 2, "spacing": "log"})", "'spacing' must be one of 'linear' and 'logarithmic'", "/axes/0/spacing"},
    {"TooManyWholeNumbers", R"({"asset": "block-1", "target": "/setup/rounds", "from": 3, "to": 6, "values": 5})", "takes whole numbers", "/axes/0/values"},
    {"TooManyPoints", R"({"target": "/setup/gain", "from": 1, "to": 2, "values": 1000001})", "a study may have", "/axes"},
    {"TwiceTheSame", R"({"target": "/setup/gain", "from": 1, "to": 2}, {"target": "/setup/gain", "from": 1, "to": 2})", "varied by two axes", "/axes/1/target"},
    {"NoAxis", "", "a study has one to three axes", "/axes"},
};
// clang-format on

class BadStudies : public testing::TestWithParam<BadStudy> {};

}  // namespace

TEST(StudyJson, ComesBackByteForByte) {
    const LoadedProject loaded = parse(with_studies(canonical));
    for (const Problem& problem : loaded.problems.items())
        ADD_FAILURE() << problem.path << ": " << problem.message.english();
    EXPECT_EQ(project_text(loaded.project), with_studies(canonical));
    const std::vector<Study>& studies = loaded.project.analyses[0].studies;
    ASSERT_EQ(studies.size(), 2u);
    EXPECT_EQ(studies[0].axes[0].spacing, StudySpacing::logarithmic);
    EXPECT_EQ(studies[0].axes[1].asset, "block-1");
    EXPECT_EQ(studies[0].trials, 5000u);
    EXPECT_EQ(studies[1].method, Method::first_order);
}

TEST(StudyJson, DoesNotChangeTheFingerprintOfTheAnalysis) {
    const auto fingerprint_of = [](const std::string& text) {
        const Project project = parse(text).project;
        Problems problems;
        return made_analysis(project, "sum-1", problems)->fingerprint();
    };
    EXPECT_EQ(fingerprint_of(whole_project), fingerprint_of(with_studies(canonical)));
}

TEST_P(BadStudies, AreSaidWithTheirPlace) {
    const LoadedProject loaded = parse(with_axis(GetParam().axis));
    const Problem problem = problem_with(loaded.problems, GetParam().message);
    EXPECT_EQ(problem.path, std::string("/analyses/0/studies/0") + GetParam().path)
        << problem.message.english();
    EXPECT_EQ(problem.severity, Severity::error);
}
INSTANTIATE_TEST_SUITE_P(All, BadStudies, testing::ValuesIn(bad_studies),
                         [](const auto& study) { return std::string(study.param.name); });

TEST(StudyJson, RefusesARepeatedIdAndUnknownOutput) {
    const std::string axis = R"("axes": [{"target": "/setup/gain", "from": 1, "to": 2}])";
    const LoadedProject loaded =
        parse(with_studies("[{\"id\": \"s\", " + axis + "}, {\"id\": \"s\", " + axis +
                           R"(, "outputs": [{"group": "lengths", "symbol": "w"}]}])"));
    EXPECT_EQ(problem_with(loaded.problems, "another study has the same id").path,
              "/analyses/0/studies/1/id");
    EXPECT_EQ(problem_with(loaded.problems, "no output quantity 'w' in 'lengths'").path,
              "/analyses/0/studies/1/outputs/0");
}

TEST(StudyValues, LinearLogarithmicAndWhole) {
    StudyAxis axis{.from = 1.0, .to = 100.0, .values = 3};
    EXPECT_EQ(axis_values(axis, false), (std::vector<double>{1.0, 50.5, 100.0}));
    EXPECT_EQ(axis_values(axis, true), (std::vector<double>{1.0, 51.0, 100.0}));
    axis.spacing = StudySpacing::logarithmic;
    const std::vector<double> values = axis_values(axis, false);
    EXPECT_DOUBLE_EQ(values[1], 10.0);
    EXPECT_EQ(values[2], 100.0);
    axis.change = StudyChange::factor;
    EXPECT_DOUBLE_EQ(axis_values(axis, true)[1], 10.0);
}

TEST(StudyTargets, ChangeWhatTheyName) {
    const Project project = parse(whole_project).project;
    const AnalysisEntry& analysis = project.analyses[0];
    const covaria::Setup& base = project.find_asset("block-1")->setup;
    const auto vary = [&](StudyAxis axis, double value) {
        axis.asset = "block-1";
        covaria::Setup varied = base;
        vary_setup(*find_study_target(project, analysis, nullptr, axis), axis, value, base, varied);
        return varied;
    };
    const Unit um = Unit::of("um"), mm = Unit::of("mm");
    EXPECT_EQ(std::get<Quantity>(vary({.target = "/setup/length", .unit = um}, 700.0).values.at("length")),
              (Quantity{700.0, um}));
    const auto cell = [](const covaria::Setup& setup, std::size_t row, std::size_t column) {
        return std::get<double>(std::get<SetupTable>(setup.values.at("points")).rows[row][column]);
    };
    EXPECT_EQ(cell(vary({.target = "/setup/points/rows/0/y", .unit = mm}, 3.0), 0, 2), 3000.0);
    const covaria::Setup column =
        vary({.target = "/setup/points/columns/x", .change = StudyChange::added, .unit = um}, 2000.0);
    EXPECT_DOUBLE_EQ(cell(column, 0, 1), -342.0);
    EXPECT_DOUBLE_EQ(cell(column, 2, 1), 2.0);
    const covaria::Setup factor =
        vary({.target = "/setup/points/columns/u", .change = StudyChange::factor}, 2.0);
    EXPECT_DOUBLE_EQ(cell(factor, 0, 3), 0.132);
    EXPECT_TRUE(
        std::holds_alternative<std::monostate>(std::get<SetupTable>(factor.values.at("points")).rows[1][3]));
    const covaria::Setup pose = vary({.target = "/setup/pose/angles/2", .unit = Unit::of("deg")}, 45.0);
    EXPECT_EQ(std::get<PoseValue>(pose.values.at("pose")).angles[2], 45.0);
}

TEST(StudyTargets, UncertaintiesAreScaledAboutTheEstimate) {
    Project project = parse(whole_project).project;
    project.analyses[0].inputs = {};
    project.analyses[0].correlations = {};
    Problems problems;
    const auto analysis = made_analysis(project, "sum-1", problems);
    ASSERT_TRUE(analysis);
    InputSet inputs = analysis->inputs;
    inputs.components[1].distribution = Distribution::of(Rectangular{1e-6, 5e-6});  // of a, with a mean
    const double before = estimate_of(inputs, 0), u = standard_uncertainty_of(inputs, 0);
    const auto scaled = [&](const std::string& pointer) {
        const StudyAxis axis{.target = pointer, .change = StudyChange::factor};
        InputSet varied = inputs;
        vary_inputs(*find_study_target(project, project.analyses[0], &inputs, axis), axis, 3.0, varied);
        return varied;
    };
    const InputSet own = scaled("/inputs/a/components");
    EXPECT_DOUBLE_EQ(estimate_of(own, 0), before);
    EXPECT_DOUBLE_EQ(standard_uncertainty_of(own, 0), 3.0 * u);
    EXPECT_EQ(standard_uncertainty_of(own, 1), standard_uncertainty_of(inputs, 1));
    const InputSet shared = scaled("/components/temperature");
    EXPECT_DOUBLE_EQ(standard_uncertainty_of(shared, 1), std::sqrt(4.0 + 9.0) * 1e-6);
    EXPECT_EQ(standard_uncertainty_of(shared, 2), standard_uncertainty_of(inputs, 2));
}

TEST(StudyTargets, ListHasOnlyWhatCanBeVaried) {
    const Project project = parse(whole_project).project;
    const auto choices = study_targets(project, project.analyses[0], nullptr);
    ASSERT_GT(choices.size(), 10u);
    bool gain = false;
    for (const StudyTargetChoice& choice : choices) {
        EXPECT_TRUE(find_study_target(project, project.analyses[0], nullptr, choice.axis))
            << choice.axis.target;
        EXPECT_FALSE(choice.target.title.empty()) << choice.axis.target;
        EXPECT_NE(choice.axis.from, choice.axis.to) << choice.axis.target;
        gain = gain || (choice.axis.target == "/setup/gain" && choice.target.current == 2.0);
    }
    EXPECT_TRUE(gain);
}

}  // namespace covaria::test::study_json_test
