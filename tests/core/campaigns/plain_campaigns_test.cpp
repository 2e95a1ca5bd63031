// Five hundred simulated campaigns of observations in groups, of a distance meter on a baseline, of a
// theodolite in rounds, of ballbars and of sensors that see the same targets.
#include <gtest/gtest.h>

#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "tests/core/campaigns/expect_campaigns.h"
#include "tests/core/kinds/network/network_project.h"
#include "tests/core/made.h"

namespace covaria::plain_campaigns_test {
namespace {

using campaigns_test::expect_campaigns;
using evidence::RedundantReadings;
using Readings = std::shared_ptr<const RedundantReadings>;

Readings readings_of(const Project& project, const std::string& analysis) {
    Problems problems;
    const auto prepared = made_analysis(project, analysis, problems);
    for (const Problem& problem : problems.items())
        if (problem.severity == Severity::error)
            ADD_FAILURE() << problem.path << " " << problem.message.english();
    return prepared && prepared->model ? prepared->model->redundant_readings() : nullptr;
}

Project project_of(const char* file) {
    return load_project(data_directory() / "projects" / file).project;
}

covaria::Setup& setup_of(Project& project, const std::string& analysis) {
    for (AnalysisEntry& entry : project.analyses)
        if (entry.id == analysis) return entry.setup;
    throw std::out_of_range(analysis);
}

/// `count` groups of `each` observations and, every other one, one more; what they read is drawn later.
Readings groups(std::size_t count, std::size_t each, bool with_between) {
    covaria::Setup setup;
    SetupTable table;
    table.units.assign(2, Unit{});
    for (std::size_t j = 0; j < count; ++j)
        for (std::size_t k = 0; k < each + j % 2; ++k)
            table.rows.push_back({"day " + std::to_string(j), double(k) + double(j % 3)});
    setup.values["observations"] = table;
    setup.values["stated_within"] = Quantity{2.0, Unit{}};
    if (with_between) setup.values["stated_between"] = Quantity{3.0, Unit{}};
    const ModelDescriptor& d = *find_model("observations-in-groups");
    Problems problems;
    check_setup(d.schema, setup, problems);
    const auto model = d.create(SetupReader(d.schema, setup), AssetLibrary{}, problems);
    return model ? model->redundant_readings() : nullptr;
}

TEST(PlainCampaigns, OfObservationsInGroups) {
    for (const double truth : {1.0, 0.5}) {
        const Readings within = groups(8, 5, false);
        ASSERT_TRUE(within);
        expect_campaigns(*within, {truth}, 11);
    }
    const Readings both = groups(30, 3, true);
    ASSERT_TRUE(both);
    expect_campaigns(*both, {1.0, 1.4}, 12);
}

TEST(PlainCampaigns, OfADistanceMeter) {
    const Project project = project_of("distance-meter.covaria");
    const Readings readings = readings_of(project, project.analyses.front().id);
    ASSERT_TRUE(readings);
    expect_campaigns(*readings, {1.0}, 13);
    expect_campaigns(*readings, {1.7}, 14);
}

TEST(PlainCampaigns, OfATheodolite) {
    const Project project = project_of("theodolite.covaria");
    const Readings readings = readings_of(project, project.analyses.front().id);
    ASSERT_TRUE(readings);
    expect_campaigns(*readings, {1.0, 1.5}, 15);
}

/// Ballbars on `count` supports, at least five, about the triangle of the project, and `points` that all of
/// them measure. `u_support`: of lengths and heights of supports, k = 2, mm.
Readings ballbars(int count, int points, double u_support) {
    Project project = project_of("ballbar-tcp.covaria");
    std::vector<Eigen::Vector3d> supports{
        {0, 0, 0}, {520, 0, 0}, {260, 450, 0}, {700, 100, 0}, {300, -300, 0}};
    for (int k = 5; k < count; ++k) {
        const double angle = 2.4 * k;  // no two in one direction
        supports.emplace_back(260.0 + (350.0 + 25.0 * k) * std::cos(angle),
                              150.0 + (350.0 + 25.0 * k) * std::sin(angle), 0.0);
    }
    SetupTable further, lengths;
    further.units.assign(5, Unit::of("mm"));
    for (std::size_t k = 3; k < supports.size(); ++k) {
        const auto to = [&](std::size_t j) { return (supports[k] - supports[j]).norm(); };
        further.rows.push_back({to(0), to(1), to(2), 0.0, u_support});
    }
    for (AssetEntry& asset : project.assets)
        if (asset.id == "ballbars") {
            asset.setup.values["further_supports"] = further;
            asset.setup.values["support_constant"] = Quantity{u_support, Unit::of("mm")};
        }
    lengths.units = {Unit{}, Unit{}, Unit::of("mm")};
    for (int k = 0; k < points; ++k) {
        const Eigen::Vector3d p(100.0 * (k % 5), 150.0 * (k / 5), 400.0 + 20.0 * k);
        for (std::size_t j = 0; j < supports.size(); ++j)
            lengths.rows.push_back(
                {"P" + std::to_string(k + 1), static_cast<double>(j + 1), (p - supports[j]).norm()});
    }
    setup_of(project, "paper").values = {
        {"ballbars", std::string("ballbars")}, {"evaluation", std::string("lengths")}, {"lengths", lengths}};
    return readings_of(project, "paper");
}

/// Supports that the bars see well: each figure has components enough.
TEST(PlainCampaigns, OfBallbars) {
    const Readings readings = ballbars(12, 8, 0.1);
    ASSERT_TRUE(readings);
    ASSERT_EQ(readings->figures.size(), 3u);  // readings, lengths between supports, heights
    expect_campaigns(*readings, {1.0, 1.0, 1.0}, 16, 2);
    expect_campaigns(*readings, {1.8, 1.0, 1.0}, 17, 2);
}

/// Nine lengths and two heights of five supports, which are as good as the readings are, stand at zero in two
/// campaigns of three. That pushes the mean factor² of the readings down by 2.4 % (u 0.4 %, of 4000
/// campaigns), a twelfth of its own standard deviation. With the weights of the truth, which nobody has, it
/// is unbiased; campaigns in which nothing stands at zero are 7 % too small, as they are those with little
/// noise.
TEST(PlainCampaigns, OfBallbarsWithFiguresOfLittleRedundancy) {
    const Readings readings = ballbars(5, 15, 0.0031);
    ASSERT_TRUE(readings);
    ASSERT_EQ(readings->figures.size(), 3u);
    const auto hold = campaigns_test::Hold::coverage_and_alarms;
    expect_campaigns(*readings, {1.0, 1.0, 1.0}, 16, 1, hold);
    expect_campaigns(*readings, {1.8, 1.0, 1.0}, 17, 1, hold);
}

/// Steps by the expected curvature alone go to and fro for ever in some of these campaigns, and figures that
/// are taken to zero on the way belong above it in others.
TEST(PlainCampaigns, EveryCampaignOfBallbarsComesToRestWhereTheLikelihoodIsLevel) {
    RedundantReadings readings = *ballbars(5, 15, 0.0031);
    std::mt19937_64 random(19);
    int at_zero = 0;
    for (int c = 0; c < 2000; ++c) {
        readings.residuals = campaigns_test::deviations(readings, {1.8, 1.0, 1.0}, random);
        const evidence::Seen seen = evidence::see(readings);
        ASSERT_TRUE(seen.found) << c;
        const Eigen::VectorXd slopes = campaigns_test::slopes(readings, seen);
        for (std::size_t k = 0; k < 3; ++k) {
            const double slope = slopes[static_cast<Eigen::Index>(k)];
            at_zero += seen.figures[k].clamped;
            if (seen.figures[k].clamped) {
                EXPECT_LT(slope, 1e-5) << c << " " << k;
            } else {
                EXPECT_NEAR(slope, 0.0, 1e-6) << c << " " << k;
            }
        }
    }
    EXPECT_GT(at_zero, 500);
}

/// Two cameras see the targets that a tracker knows much better. What the tracker states is controlled by
/// nothing, with a redundancy of some hundredths: it stays as stated. An estimate of it would run away, and
/// take from the figures of the cameras up to half of the redundancy that they have.
TEST(PlainCampaigns, OfSensors) {
    Network network;
    network.keep_sensors({"camera-1", "camera-2", "laser-tracker"}, "recommended");
    network.table("distances", "recommended").rows.clear();
    auto& targets = network.table("targets", "recommended").rows;
    targets.clear();
    std::vector<std::string> names;
    for (int k = 0; k < 18; ++k) {
        names.push_back("T" + std::to_string(k + 1));
        targets.push_back(
            {names.back(), 4000.0 + 90.0 * k, -900.0 + 350.0 * (k % 6), -400.0 + 300.0 * (k % 4), false});
    }
    const auto planned = network.prepare("recommended");
    ASSERT_TRUE(planned) << network.words();
    SetupTable table;
    table.units = {Unit(), Unit(), Unit::of("mm"), Unit::of("rad"), Unit::of("rad")};
    const std::pair<const char*, const char*> sensors[] = {
        {"camera-1", "C1"}, {"camera-2", "C2"}, {"laser-tracker", "LT"}};
    for (const std::string& target : names)
        for (const auto& [sensor, label] : sensors) {
            const auto cell = [&](const char* letter, double factor) -> SetupCell {
                const std::size_t i = planned->inputs.find(std::string(letter) + "_" + target + "_" + label);
                if (i == InputSet::npos) return {};
                return factor * estimate_of(planned->inputs, i);
            };
            table.rows.push_back(
                {target, std::string(sensor), cell("d", 1e3), cell("theta", 1.0), cell("phi", 1.0)});
        }
    network.setup("recommended").values["evaluation"] = std::string("a-posteriori");
    network.setup("recommended").values["readings"] = table;
    const Readings readings = readings_of(network.project, "recommended");
    ASSERT_TRUE(readings);
    ASSERT_EQ(readings->figures.size(), 7u);
    expect_campaigns(*readings, {1.0, 1.5, 0.6, 1.0, 1.0, 1.0, 1.0}, 18, 4);
}

}  // namespace
}  // namespace covaria::plain_campaigns_test
