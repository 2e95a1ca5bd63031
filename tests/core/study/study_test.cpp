// Studies of real models: every grid point is what a project with those values gives; bits, threads, stops.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "core/base/resource_path.h"
#include "core/study/study.h"
#include "tests/core/made.h"

namespace covaria::study_test {
namespace {

const Unit mm = Unit::of("mm");

Project network() {
    Project project = load_project(data_directory() / "projects/lsm-network.covaria").project;
    project.analyses.erase(project.analyses.begin());  // keeps "recommended"
    project.analyses[0].studies.clear();
    project.analyses[0].options.method = Method::first_order;
    return project;
}

StudyAxis cell_of_b(const std::string& column, double from, double to, std::size_t values) {
    return {
        .target = "/setup/targets/rows/1/" + column, .from = from, .to = to, .unit = mm, .values = values};
}

std::shared_ptr<const PreparedStudy> prepared(const Project& project, Problems& problems) {
    return prepare_study(MadeProject::make(project), "recommended", project.analyses[0].studies[0].id,
                         problems);
}

StudyResult run(const Project& project, int threads = 2) {
    Problems problems;
    const auto study = prepared(project, problems);
    for (const Problem& problem : problems.items())
        ADD_FAILURE() << problem.path << ": " << problem.message.english();
    return *run_study(*study, {{}, {}, threads});
}

UncertaintyResult whole_result(const Project& project) {
    Problems problems;
    const auto analysis = made_analysis(project, "recommended", problems);
    return *run_analysis(*analysis);
}

double& cell(Project& project, std::size_t row, std::size_t column) {
    auto& table = std::get<SetupTable>(project.analyses[0].setup.values.at("targets"));
    return std::get<double>(table.rows[row][column]);
}

void expect_equal(const StudyResult& a, const StudyResult& b) {
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        ASSERT_EQ(a.points[i].values.size(), b.points[i].values.size());
        for (std::size_t j = 0; j < a.points[i].values.size(); ++j) {
            EXPECT_EQ(a.points[i].values[j].estimate, b.points[i].values[j].estimate);
            EXPECT_EQ(a.points[i].values[j].standard_uncertainty, b.points[i].values[j].standard_uncertainty);
        }
    }
}

TEST(Study, AnInstrumentIsVariedInsideItsNetwork) {
    Project project = load_project(data_directory() / "projects/tracker-pose.covaria").project;
    project.analyses.erase(project.analyses.begin() + 1, project.analyses.end());
    AnalysisEntry& analysis = project.analyses[0];
    analysis.options.method = Method::first_order;
    analysis.studies = {{.id = "s",
                         .axes = {{.asset = "tracker",
                                   .target = "/setup/u_scale",
                                   .from = 1,
                                   .to = 50,
                                   .unit = Unit::of("ppm"),
                                   .values = 2}},
                         .outputs = {{"pose 1", "z"}}}};
    Problems problems;
    const auto study = prepare_study(MadeProject::make(project), analysis.id, "s", problems);
    ASSERT_TRUE(study);
    const StudyResult result = *run_study(*study, {});
    for (const std::size_t point : {0, 1}) {
        project.assets[0].setup.values["u_scale"] = Quantity{point == 0 ? 1.0 : 50.0, Unit::of("ppm")};
        const auto changed = made_analysis(project, analysis.id, problems);
        ASSERT_TRUE(changed);
        const UncertaintyResult whole = *run_analysis(*changed);
        EXPECT_DOUBLE_EQ(result.points[point].values[0].standard_uncertainty,
                         whole.outputs[2].standard_uncertainty);
    }
    EXPECT_GT(result.points[1].values[0].standard_uncertainty,
              result.points[0].values[0].standard_uncertainty);
}

/// An analysis that this one takes from is varied like an asset.
TEST(Study, AnAnalysisUpstreamIsVaried) {
    Project project = load_project(data_directory() / "projects/chain.covaria").project;
    std::erase_if(project.analyses, [](const auto& a) { return a.id != "bar" && a.id != "network"; });
    ASSERT_EQ(project.analyses.size(), 2u);
    AnalysisEntry &bar = project.analyses[0], &network = project.analyses[1];
    network.options.method = Method::first_order;
    network.studies = {{.id = "s",
                        .axes = {{.asset = "bar",
                                  .target = "/setup/quantities/rows/0/a",
                                  .change = StudyChange::factor,
                                  .from = 1.0,
                                  .to = 50.0,
                                  .values = 3}}}};
    Problems problems;
    const auto study = prepare_study(MadeProject::make(project), "network", "s", problems);
    ASSERT_TRUE(study) << (problems.items().empty() ? "" : problems.items()[0].message.english());
    const StudyResult result = *run_study(*study, {});
    EXPECT_NE(result.axes[0].title.message().english().find(bar.name.empty() ? bar.id : bar.name),
              std::string::npos);
    ASSERT_EQ(result.points.size(), 3u);
    for (std::size_t point = 0; point < 3; ++point) {
        Project changed = project;
        auto& table = std::get<SetupTable>(changed.analyses[0].setup.values.at("quantities"));
        double& a = std::get<double>(table.rows[0][5]);
        ASSERT_EQ(a, 0.004);
        a *= result.axes[0].values[point];
        const auto made = made_analysis(changed, "network", problems);
        ASSERT_TRUE(made);
        const UncertaintyResult whole = *run_analysis(*made);
        std::size_t compared = 0;
        for (std::size_t j = 0; j < result.outputs.size(); ++j)
            for (const OutputResult& output : whole.outputs) {
                if (output.quantity.symbol != result.outputs[j].symbol ||
                    output.quantity.group != result.outputs[j].group)
                    continue;
                EXPECT_EQ(result.points[point].values[j].standard_uncertainty, output.standard_uncertainty);
                ++compared;
            }
        EXPECT_EQ(compared, result.outputs.size());
    }
    EXPECT_NE(result.points[0].values[0].standard_uncertainty,
              result.points[2].values[0].standard_uncertainty);
    // The bar takes nothing from the network.
    bar.studies = network.studies;
    bar.studies[0].axes[0].asset = "network";
    EXPECT_FALSE(prepare_study(MadeProject::make(project), "bar", "s", problems));
}

TEST(Study, EveryGridPointIsWhatTheChangedProjectGives) {
    Project project = network();
    project.analyses[0].studies = {{.id = "s",
                                    .axes = {cell_of_b("x", 3000, 6000, 3),
                                             {.asset = "laser-tracker",
                                              .target = "/setup/u_station_kappa",
                                              .change = StudyChange::factor,
                                              .from = 0.1,
                                              .to = 2,
                                              .values = 2}},
                                    .outputs = {{"B", "x"}, {"B", "y"}, {"B", "z"}, {"distances", "AB"}}}};
    const StudyResult study = run(project);
    ASSERT_EQ(study.points.size(), 6u);
    ASSERT_EQ(study.triples.size(), 1u);
    EXPECT_EQ(study.axes[0].title.message().english(), "Targets, B: x");
    for (std::size_t i = 0; i < 6; ++i) {
        Project changed = network();
        const auto at = study.indices_of(i);
        cell(changed, 1, 1) = study.axes[0].values[at[0]];
        for (AssetEntry& asset : changed.assets)
            if (asset.id == "laser-tracker")
                std::get<Quantity>(asset.setup.values.at("u_station_kappa")).value *=
                    study.axes[1].values[at[1]];
        const UncertaintyResult whole = whole_result(changed);
        ASSERT_TRUE(study.points[i].has_values());
        for (std::size_t j = 0; j < study.outputs.size(); ++j)
            for (const OutputResult& output : whole.outputs) {
                if (output.quantity.symbol != study.outputs[j].symbol ||
                    output.quantity.group != study.outputs[j].group)
                    continue;
                EXPECT_EQ(study.points[i].values[j].estimate, output.estimate);
                EXPECT_EQ(study.points[i].values[j].standard_uncertainty, output.standard_uncertainty);
                EXPECT_EQ(study.points[i].values[j].expanded_uncertainty, output.expanded_uncertainty);
            }
        const StudyPlace& place = study.points[i].places[0];
        EXPECT_NEAR(place.p_W.x(), study.axes[0].values[at[0]] * 1e-3, 1e-12);
        EXPECT_EQ(place.covariance, whole.covariance.among({3, 4, 5}));
    }
}

TEST(Study, MonteCarloOfAGridPointIsThatOfTheProject) {
    Project project = network();
    project.analyses[0].options.seed = 7;
    project.analyses[0].studies = {{.id = "s",
                                    .axes = {cell_of_b("x", 4000, 5000, 2)},
                                    .method = Method::monte_carlo,
                                    .trials = 12'345}};
    const StudyResult study = run(project);
    project.analyses[0].options.method = Method::monte_carlo;
    project.analyses[0].options.trials = 12'345;
    cell(project, 1, 1) = 5000;
    const UncertaintyResult whole = whole_result(project);
    ASSERT_EQ(study.outputs.size(), whole.outputs.size());
    for (std::size_t j = 0; j < study.outputs.size(); ++j) {
        const double u = whole.outputs[j].standard_uncertainty;
        EXPECT_NEAR(study.points[1].values[j].estimate, whole.outputs[j].estimate, 1e-9 * u);
        EXPECT_NEAR(study.points[1].values[j].standard_uncertainty, u, 1e-9 * u);
        EXPECT_NEAR(study.points[1].values[j].expanded_uncertainty, whole.outputs[j].expanded_uncertainty,
                    1e-8 * u);
    }
}

TEST(Study, SameBitsForAnyNumberOfThreads) {
    Project project = network();
    project.analyses[0].studies = {{.id = "s",
                                    .axes = {cell_of_b("x", 3000, 6000, 3), cell_of_b("y", -500, 500, 3)},
                                    .method = Method::monte_carlo,
                                    .trials = 2'500}};
    const StudyResult one = run(project, 1);
    expect_equal(one, run(project, 2));
    expect_equal(one, run(project, 5));
}

TEST(Study, PointsWithoutValuesKeepTheirReason) {
    Project project = network();
    // from behind the cameras to between them and the tracker
    project.analyses[0].studies = {{.id = "s", .axes = {cell_of_b("x", -4000, 4000, 5)}}};
    const StudyResult study = run(project);
    ASSERT_EQ(study.points.size(), 5u);
    EXPECT_FALSE(study.points[0].has_values());
    EXPECT_NE(study.reasons[study.points[0].reason].english().find("C1"), std::string::npos)
        << study.reasons[study.points[0].reason];
    EXPECT_TRUE(study.points[4].has_values());
    EXPECT_EQ(study.points[0].values.size(), 0u);
    EXPECT_GE(study.failed(), 2u);
    const StudyQuantity quantity = study_quantities(study).front();
    EXPECT_TRUE(std::isnan(value_at(study, quantity, 0)));
    const StudyExtremes extremes = extremes_of(study, quantity);
    ASSERT_TRUE(extremes.known);
    EXPECT_LE(value_at(study, quantity, extremes.best), value_at(study, quantity, extremes.worst));
}

TEST(Study, UncertaintyOfAnInputQuantityByAFactor) {
    Project project = network();
    const std::string symbol = [&] {
        Problems problems;
        const auto analysis = made_analysis(project, "recommended", problems);
        return analysis->inputs.quantities.front().symbol;
    }();
    project.analyses[0].studies = {{.id = "s",
                                    .axes = {{.target = "/inputs/" + symbol + "/components",
                                              .change = StudyChange::factor,
                                              .from = 0,
                                              .to = 2,
                                              .values = 3}}}};
    const StudyResult study = run(project);
    const UncertaintyResult whole = whole_result(project);
    for (std::size_t j = 0; j < study.outputs.size(); ++j) {
        // u^2 = a + b f^2
        const auto variance = [&](std::size_t i) {
            return std::pow(study.points[i].values[j].standard_uncertainty, 2);
        };
        EXPECT_NEAR(variance(2) - variance(0), 4.0 * (variance(1) - variance(0)), 1e-9 * variance(2));
        EXPECT_NEAR(std::sqrt(variance(1)), whole.outputs[j].standard_uncertainty,
                    1e-12 * whole.outputs[j].standard_uncertainty);
    }
    EXPECT_LT(study.points[0].values[0].standard_uncertainty, study.points[2].values[0].standard_uncertainty);
}

TEST(Study, DefaultsOfTheSchemaCanBeVaried) {
    Project project = network();
    project.analyses[0].studies = {{.id = "s",
                                    .axes = {{.asset = "laser-tracker",
                                              .target = "/setup/distance_constant",
                                              .from = 0,
                                              .to = 100,
                                              .unit = Unit::of("um"),
                                              .values = 2}}}};
    Problems problems;
    const auto study = prepared(project, problems);
    if (!study) GTEST_FAIL() << problems.items()[0].message.english();
    const StudyResult result = *run_study(*study);
    EXPECT_TRUE(result.points[0].has_values() && result.points[1].has_values());
}

TEST(Study, StopsWithinATenthOfASecond) {
    Project project = network();
    project.analyses[0].studies = {{.id = "s",
                                    .axes = {cell_of_b("x", 3000, 6000, 3)},
                                    .method = Method::monte_carlo,
                                    .trials = 1'000'000'000}};
    Problems problems;
    const auto study = prepared(project, problems);
    ASSERT_TRUE(study);
    std::stop_source stop;
    std::uint64_t planned = 0;
    RunControl control{stop.get_token(),
                       [&](const Progress& progress) {
                           planned = progress.trials_planned;
                           stop.request_stop();
                       },
                       2};
    const auto result = run_study(*study, control);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    EXPECT_EQ(planned, 3'000'000'000u);
}

TEST(Study, AssetThatIsNotUsedIsRefused) {
    Project project = network();
    AssetEntry other = project.assets.back();
    other.id = "spare";
    project.assets.push_back(other);
    project.analyses[0].studies = {{.id = "s",
                                    .axes = {{.asset = "spare",
                                              .target = "/setup/u_station_kappa",
                                              .from = 1,
                                              .to = 2,
                                              .unit = Unit::of("mrad"),
                                              .values = 2}}}};
    Problems problems;
    EXPECT_FALSE(prepared(project, problems));
    ASSERT_FALSE(problems.empty());
    EXPECT_EQ(problems.items()[0].path, "/analyses/0/studies/0/axes/0/asset");
    EXPECT_NE(problems.items()[0].message.english().find("does not use"), std::string::npos);
}

TEST(Study, FingerprintFollowsWhatMatters) {
    Project project = network();
    project.analyses[0].studies = {{.id = "s", .axes = {cell_of_b("x", 3000, 6000, 3)}}};
    Problems problems;
    const std::string before = prepared(project, problems)->fingerprint;
    project.analyses[0].studies[0].name = "another name";
    project.analyses[0].studies.push_back({.id = "t", .axes = {cell_of_b("y", 0, 1, 2)}});
    EXPECT_EQ(prepared(project, problems)->fingerprint, before);
    project.analyses[0].studies[0].axes[0].to = 6001;
    EXPECT_NE(prepared(project, problems)->fingerprint, before);
}

/// Fewer trials than plain Monte Carlo needs for a hundredth of u, and the answer of some hundred thousand.
TEST(Study, ControlVariatesGiveTheAnswerOfManyTrials) {
    Project project = network();
    Study study{.id = "s",
                .axes = {cell_of_b("x", 3500, 4500, 3)},
                .outputs = {{"B", "x"}, {"B", "y"}, {"B", "z"}},
                .method = Method::monte_carlo};
    const auto run_with = [&](VarianceReduction reduction, std::uint64_t trials, int threads) {
        study.trials = trials;
        project.analyses[0].options.variance_reduction = reduction;
        project.analyses[0].studies = {study};
        return run(project, threads);
    };
    constexpr std::uint64_t many = 400'000, few = 2'000;
    const StudyResult reference = run_with(VarianceReduction::none, many, 2);
    const StudyResult reduced = run_with(VarianceReduction::control_variate, few, 2);
    expect_equal(reduced, run_with(VarianceReduction::control_variate, few, 1));
    const double of_u = 4.0 / std::sqrt(2.0 * many);
    // An end of the 95 % interval: root of q (1 - q) over the density of a normal distribution there.
    const double of_end = 4.0 * std::sqrt(0.025 * 0.975 / many) / 0.0584;
    for (std::size_t i = 0; i < reference.points.size(); ++i)
        for (std::size_t j = 0; j < reference.outputs.size(); ++j) {
            const StudyValue &a = reduced.points[i].values[j], &b = reference.points[i].values[j];
            const double u = b.standard_uncertainty;
            EXPECT_NEAR(a.estimate, b.estimate, 4.0 * u / std::sqrt(many));
            EXPECT_NEAR(a.standard_uncertainty, u, of_u * u);
            EXPECT_NEAR(a.expanded_uncertainty, b.expanded_uncertainty, of_end * u);
        }
}

}  // namespace
}  // namespace covaria::study_test
