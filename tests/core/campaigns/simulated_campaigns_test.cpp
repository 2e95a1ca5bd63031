// Five hundred simulated campaigns of three set-ups of this program: a network, the identification of an arm,
// rounds of a total station. Factors are unbiased, stated intervals cover, alarms come at their level.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <random>

#include "core/base/resource_path.h"
#include "core/evidence/seen.h"
#include "tests/core/made.h"
#include "tests/core/table_rows.h"

namespace covaria::campaigns_test {
namespace {

using evidence::RedundantReadings;
using evidence::Seen;

constexpr int campaigns = 500;

std::shared_ptr<const RedundantReadings> readings_of(const char* project, const char* analysis) {
    const LoadedProject loaded = load_project(data_directory() / "projects" / project);
    Problems problems;
    const auto prepared = made_analysis(loaded.project, analysis, problems);
    return prepared && prepared->model ? prepared->model->redundant_readings() : nullptr;
}

/// Random deviations of readings; the part that unknowns take up is of no consequence.
Eigen::VectorXd deviations(const RedundantReadings& readings, const std::vector<double>& truth,
                           std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const auto noise = [&](Eigen::Index n) {
        Eigen::VectorXd e(n);
        for (double& value : e) value = normal(random);
        return e;
    };
    if (!readings.shares.empty()) {
        Eigen::VectorXd e = readings.others * noise(readings.others.cols());
        for (std::size_t k = 0; k < readings.shares.size(); ++k)
            e += truth[k] * readings.shares[k] * noise(readings.shares[k].cols());
        return e;
    }
    Eigen::VectorXd e = noise(readings.residuals.size());
    for (Eigen::Index i = 0; i < e.size(); ++i)
        e[i] *= truth[readings.figure_of[static_cast<std::size_t>(i)]] / readings.whitening.coeff(i, i);
    return e;
}

/// `truth`: of each figure, over what is stated.
void expect_campaigns(const RedundantReadings& stated, const std::vector<double>& truth, unsigned seed) {
    ASSERT_EQ(stated.figures.size(), truth.size());
    RedundantReadings readings = stated;
    std::mt19937_64 random(seed);
    std::vector<double> sum(truth.size()), squares(truth.size());
    std::vector<int> covered(truth.size()), alarms(truth.size());
    for (int c = 0; c < campaigns; ++c) {
        readings.residuals = deviations(readings, truth, random);
        const Seen seen = evidence::see(readings);
        ASSERT_TRUE(seen.found);
        for (std::size_t k = 0; k < truth.size(); ++k) {
            const evidence::SeenFigure& figure = seen.figures[k];
            ASSERT_GE(figure.redundancy, evidence::least_redundancy) << k;
            sum[k] += figure.square;
            squares[k] += figure.square * figure.square;
            covered[k] += figure.low <= truth[k] && truth[k] <= figure.high;
            alarms[k] += figure.verdict != evidence::Verdict::agrees;
        }
    }
    for (std::size_t k = 0; k < truth.size(); ++k) {
        const double mean = sum[k] / campaigns;
        const double s = std::sqrt((squares[k] - campaigns * mean * mean) / (campaigns - 1.0));
        EXPECT_NEAR(mean, truth[k] * truth[k], 2.0 * s / std::sqrt(campaigns)) << k;
        EXPECT_GE(covered[k], 0.93 * campaigns) << k;
        EXPECT_LE(covered[k], 0.97 * campaigns) << k;
        // A right figure is contradicted by chance.
        if (truth[k] == 1.0) {
            EXPECT_NEAR(alarms[k], 0.05 * campaigns, 2.0 * std::sqrt(0.05 * 0.95 * campaigns)) << k;
        }
        std::printf("figure %zu: mean factor² %.4f of %.4f (u %.4f), covered %.1f %%\n", k, mean,
                    truth[k] * truth[k], s / std::sqrt(campaigns), 100.0 * covered[k] / campaigns);
    }
}

TEST(SimulatedCampaigns, OfANetwork) {
    const auto readings = readings_of("seen-network.covaria", "stated");
    ASSERT_TRUE(readings);
    expect_campaigns(*readings, {1.3, 1.0, 0.33}, 1);
}

TEST(SimulatedCampaigns, OfRoundsOfATotalStation) {
    const auto readings = readings_of("seen-chain.covaria", "rounds");
    ASSERT_TRUE(readings);
    expect_campaigns(*readings, {1.0, 1.5, 0.4}, 2);
}

TEST(SimulatedCampaigns, OfTheIdentificationOfAnArm) {
    const auto readings = readings_of("er10l-c10.covaria", "poses-measured");
    ASSERT_TRUE(readings);
    for (const double truth : {1.0, 2.0})
        expect_campaigns(*readings, std::vector<double>(readings->figures.size(), truth), 3);
}

/// A pose that was measured in another place than the arm stood is found without help.
TEST(TrackerData, ADisplacedPoseIsFoundAndAnInseparablePairIsNamed) {
    Project project = load_project(data_directory() / "projects/er10l-c10.covaria").project;
    constexpr std::size_t displaced = 16, x_column = 9;
    for (AnalysisEntry& analysis : project.analyses) {
        if (analysis.id != "poses-measured") continue;
        auto& x = std::get<SetupTable>(analysis.setup.values.at("poses")).rows[displaced][x_column];
        x = std::get<double>(x) + 0.2;
    }
    Problems problems;
    const auto prepared = made_analysis(project, "poses-measured", problems);
    ASSERT_TRUE(prepared && prepared->model);
    const auto readings = prepared->model->redundant_readings();
    std::size_t worst = 0;
    for (std::size_t i = 0; i < readings->w.size(); ++i)
        if (std::abs(readings->w[i]) > std::abs(readings->w[worst])) worst = i;
    EXPECT_EQ(readings->names[worst].english(), "P17, x");
    bool said = false;
    for (const Problem& problem : problems.items())
        said = said || problem.message.english().starts_with("pose P17: the residual of its x");
    EXPECT_TRUE(said);
    bool named = false;
    for (const Table& table : prepared->model->evaluation())
        for (const auto& row : test::rows_of(table))
            for (const Cell& cell : row)
                if (const auto* words = std::get_if<Message>(&cell))
                    named = named || words->english().starts_with("moves the measured points as ");
    EXPECT_TRUE(named);
}

}  // namespace
}  // namespace covaria::campaigns_test
