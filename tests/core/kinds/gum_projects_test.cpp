// The worked examples of JCGM 100, 101 and 102 and the other cases as projects: what `covaria verify` checks,
// its reference values against those of the fixtures, and the file itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "core/project/project_file.h"
#include "core/verification/verification.h"
#include "tests/core/made.h"

namespace covaria::gum_projects_test {
namespace {

using Json = nlohmann::json;

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<VerificationCase> shipped() {
    const auto cases = shipped_verification();
    EXPECT_TRUE(cases) << cases.error().message.english();
    return cases.value_or(std::vector<VerificationCase>{});
}

class GumProject : public testing::TestWithParam<VerificationCase> {};
class GumProjectOfTrials : public GumProject {};

std::vector<VerificationCase> shipped_of_trials() {
    std::vector<VerificationCase> cases = shipped();
    std::erase_if(cases, [](const VerificationCase& c) {
        return std::none_of(c.checks.begin(), c.checks.end(), needs_trials);
    });
    return cases;
}

/// The figures of a case, evaluated with this option; without one as its project says.
CheckedCase checked(const VerificationCase& verification, std::optional<VarianceReduction> reduction = {}) {
    LoadedProject loaded = load_project(data_directory() / verification.project);
    for (const Problem& p : loaded.problems.items())
        if (p.severity == Severity::error) ADD_FAILURE() << p.path << " " << p.message.english();
    std::vector<EvaluatedAnalysis> evaluated;
    std::set<std::string> wanted;
    for (const VerificationCheck& check : verification.checks) wanted.insert(check.analysis);
    for (AnalysisEntry& entry : loaded.project.analyses) {
        if (!wanted.contains(entry.id)) continue;
        if (reduction) entry.options.variance_reduction = *reduction;
        Problems problems;
        const auto prepared = made_analysis(loaded.project, entry.id, problems);
        auto result = prepared ? run_analysis(*prepared)
                               : Result<UncertaintyResult>(fail(ErrorCode::bad_input, entry.id));
        EXPECT_TRUE(result) << result.error().message.english();
        if (!result) return {};
        evaluated.push_back(
            {prepared, std::make_shared<const UncertaintyResult>(std::move(*result)), {}, {}});
    }
    const auto checked = check_case(verification, evaluated);
    EXPECT_TRUE(checked) << checked.error().message.english();
    return checked.value_or(CheckedCase{});
}

TEST_P(GumProject, ReproducesPublishedAndReferenceValues) {
    const CheckedCase found = checked(GetParam());
    EXPECT_TRUE(found.passed());
    EXPECT_FALSE(found.figures.empty());
    for (const CheckedFigure& f : found.figures) {
        EXPECT_TRUE(f.agrees_with_reference) << f.check.what << ": " << f.value << " +- " << f.tolerance
                                             << ", reference " << f.check.reference.value_or(0);
        EXPECT_TRUE(f.differs_from_naive) << f.check.what << ": " << f.value;
        EXPECT_TRUE(f.reproduces_published || !f.check.because.empty())
            << f.check.what << ": " << f.value << ", published " << f.check.published.value_or(0);
    }
}

// Within four combined standard errors of the reference, as plain trials are.
TEST_P(GumProjectOfTrials, AgreesWithTheReferenceWithControlVariates) {
    const CheckedCase found = checked(GetParam(), VarianceReduction::control_variate);
    EXPECT_FALSE(found.figures.empty());
    for (const CheckedFigure& f : found.figures)
        EXPECT_TRUE(f.agrees_with_reference) << f.check.what << ": " << f.value << " +- " << f.tolerance
                                             << ", reference " << f.check.reference.value_or(0);
}

const std::vector<std::string> folders{"projects/gum", "resources/verification"};

std::set<std::string> project_files() {
    std::set<std::string> files;
    for (const std::string& folder : folders)
        for (const auto& entry : std::filesystem::directory_iterator(data_directory() / folder))
            if (entry.path().extension() == ".covaria")
                files.insert(folder + "/" + entry.path().filename().string());
    return files;
}

// A case for every project of these folders.
TEST(GumProjects, AreAllVerified) {
    std::set<std::string> verified;
    for (const VerificationCase& c : shipped()) verified.insert(c.project);
    EXPECT_GE(project_files().size(), 20u);
    for (const std::string& file : project_files()) EXPECT_TRUE(verified.contains(file)) << file;
}

TEST(GumProjects, AreWrittenByteForByte) {
    for (const std::string& file : project_files())
        EXPECT_EQ(project_text(load_project(data_directory() / file).project),
                  text_of(data_directory() / file))
            << file;
}

// A figure that nobody compares may be wrong for long: U of Monte Carlo was. So of each output that occurs,
// the whole result line is compared, by each method that runs.
TEST(Verification, ComparesEveryFigureOfTheResultLine) {
    std::size_t compared = 0;
    for (const VerificationCase& c : shipped()) {
        std::map<std::tuple<std::string, std::string, std::string>, std::set<std::string>> lines;
        compared += c.checks.size();
        for (const VerificationCheck& check : c.checks)
            if (!check.cell) lines[{check.analysis, check.output, check.group}].insert(check.figure);
        const Project project = load_project(data_directory() / c.project).project;
        for (const auto& [output, figures] : lines) {
            // At a kink, as that of a maximum of equal estimates, the law of propagation gives nothing.
            std::vector<std::string> needed;
            if (!c.source.starts_with("order statistics")) needed = first_order_line();
            // Sums are about ends and tests of normality; the line of each distribution is in another case.
            if (c.source.starts_with("distribution function of the sum")) continue;
            for (const AnalysisEntry& entry : project.analyses)
                if (entry.id == std::get<0>(output) && entry.options.method != Method::first_order) {
                    // Of a copula only the moments have a closed form.
                    const std::vector<std::string> of_trials =
                        c.source.starts_with("moments") ? std::vector<std::string>{"mc-mean", "mc-u"}
                                                        : monte_carlo_line();
                    needed.insert(needed.end(), of_trials.begin(), of_trials.end());
                }
            for (const std::string& figure : needed)
                EXPECT_TRUE(figures.contains(figure)) << c.title << ", " << std::get<0>(output) << ", "
                                                      << std::get<1>(output) << ": " << figure;
        }
    }
    EXPECT_GE(compared, 5000u);
}

TEST(Verification, EveryFigureHasASourceAndSomethingToCompareWith) {
    for (const VerificationCase& c : shipped()) {
        EXPECT_FALSE(c.source.empty()) << c.title;
        for (const VerificationCheck& check : c.checks) {
            EXPECT_TRUE(check.published || check.reference) << c.title << ": " << check.what;
            EXPECT_TRUE(!check.reference || std::isinf(*check.reference) || check.relative > 0.0 ||
                        check.absolute > 0.0 || check.scatter > 0.0 || check.condition > 0.0 ||
                        check.figure == "validated")
                << c.title << ": " << check.what;
            EXPECT_LE(check.relative, 0.05) << c.title << ": " << check.what;
        }
    }
}

// The shipped reference values are those of tests/data/gum_examples.json, to a factor of ten of the unit.
TEST(GumProjects, ReferenceValuesAreThoseOfTheFixtures) {
    const Json all = Json::parse(text_of(COVARIA_SOURCE_DIR "/tests/data/gum_examples.json"));
    std::map<std::string, Json> examples;
    for (const Json& example : all.at("examples")) examples[example.at("id")] = example;
    std::size_t compared = 0;
    for (const VerificationCase& c : shipped())
        for (const VerificationCheck& check : c.checks) {
            if (check.entry.empty()) continue;
            const std::size_t slash = check.entry.find('/');
            const Json& found =
                examples.at(check.entry.substr(0, slash)).at(Json::json_pointer(check.entry.substr(slash)));
            const double expected = found.is_object()    ? found.at("value").get<double>()
                                    : found.is_boolean() ? (found.get<bool>() ? 1.0 : 0.0)
                                                         : found.get<double>();
            EXPECT_NEAR(*check.reference, expected, 1e-9 * std::abs(expected)) << check.entry;
            ++compared;
        }
    EXPECT_GT(compared, 100u);
}

TEST(Verification, FailsWhereAValueIsWrong) {
    std::vector<VerificationCase> cases = shipped();
    ASSERT_FALSE(cases.empty());
    CheckedFigure figure{cases[0].checks[0], 1.0, 0.1, true, true};
    EXPECT_TRUE(figure.passed());
    figure.agrees_with_reference = false;
    EXPECT_FALSE(figure.passed());
    figure = {cases[0].checks[0], 1.0, 0.1, true, false};
    figure.check.because = "";
    EXPECT_FALSE(figure.passed());
    figure.check.because = "the standard rounds";
    EXPECT_TRUE(figure.passed());
    EXPECT_NE(verification_text({{cases[0], {figure}}}).find("differs, because the standard rounds"),
              std::string::npos);
}

std::string name_of(const testing::TestParamInfo<VerificationCase>& info) {
    std::string name;
    for (const char c : info.param.title) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Gum, GumProject, testing::ValuesIn(shipped()), name_of);
INSTANTIATE_TEST_SUITE_P(Gum, GumProjectOfTrials, testing::ValuesIn(shipped_of_trials()), name_of);

}  // namespace
}  // namespace covaria::gum_projects_test
