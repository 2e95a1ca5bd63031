// The worked examples of JCGM 100, 101 and 102 as projects: what `covaria verify` checks, its reference
// values against those of the fixtures, and the file itself.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/resource_path.h"
#include "core/project/project_file.h"
#include "core/report/verification.h"

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
    const auto cases = read_verification(text_of(data_directory() / "resources" / "verification.json"));
    EXPECT_TRUE(cases) << cases.error().message;
    return cases.value_or(std::vector<VerificationCase>{});
}

class GumProject : public testing::TestWithParam<VerificationCase> {};

TEST_P(GumProject, ReproducesPublishedAndReferenceValues) {
    const VerificationCase& verification = GetParam();
    const LoadedProject loaded = load_project(data_directory() / "projects" / verification.project);
    for (const Problem& p : loaded.problems.items()) ADD_FAILURE() << p.path << " " << p.message;
    Problems problems;
    const AssetLibrary assets = make_assets(loaded.project, problems);
    std::vector<EvaluatedAnalysis> evaluated;
    for (const AnalysisEntry& entry : loaded.project.analyses) {
        const auto prepared = prepare_analysis(loaded.project, entry.id, assets, problems);
        ASSERT_TRUE(prepared) << entry.id;
        auto result = run_analysis(*prepared);
        ASSERT_TRUE(result) << result.error().message;
        evaluated.push_back(
            {prepared, std::make_shared<const UncertaintyResult>(std::move(*result)), {}, {}});
    }
    const auto checked = check_case(verification, evaluated);
    ASSERT_TRUE(checked) << checked.error().message;
    EXPECT_TRUE(checked->passed());
    for (const CheckedFigure& f : checked->figures) {
        EXPECT_TRUE(f.agrees_with_reference) << f.check.what << ": " << f.value << " +- " << f.tolerance
                                             << ", reference " << f.check.reference.value_or(0);
        EXPECT_TRUE(f.reproduces_published || !f.check.because.empty())
            << f.check.what << ": " << f.value << ", published " << f.check.published.value_or(0);
    }
}

// A case for every project in projects/gum, and the other way round.
TEST(GumProjects, AreAllVerified) {
    std::set<std::string> verified, files;
    for (const VerificationCase& c : shipped())
        if (c.project.starts_with("gum/")) verified.insert(c.project);
    for (const auto& entry : std::filesystem::directory_iterator(data_directory() / "projects" / "gum"))
        if (entry.path().extension() == ".covaria") files.insert("gum/" + entry.path().filename().string());
    EXPECT_GE(files.size(), 9u);
    EXPECT_EQ(verified, files);
}

TEST(GumProjects, AreWrittenByteForByte) {
    for (const auto& entry : std::filesystem::directory_iterator(data_directory() / "projects" / "gum")) {
        if (entry.path().extension() != ".covaria") continue;
        EXPECT_EQ(project_text(load_project(entry.path()).project), text_of(entry.path())) << entry.path();
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
    for (const char c : info.param.project) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Gum, GumProject, testing::ValuesIn(shipped()), name_of);

}  // namespace
}  // namespace covaria::gum_projects_test
