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

/// A set of ballbars with five supports, and points above them. Disabled: with two figures of little
/// redundancy beside it, the first is seen 2.4 % (u 0.9 %) too small, which is to be understood.
TEST(PlainCampaigns, DISABLED_OfBallbars) {
    Project project = project_of("ballbar-tcp.covaria");
    const std::vector<Eigen::Vector3d> supports{
        {0, 0, 0}, {520, 0, 0}, {260, 450, 0}, {700, 100, 0}, {300, -300, 0}};
    SetupTable further, lengths;
    further.units.assign(5, Unit::of("mm"));
    for (std::size_t k = 3; k < supports.size(); ++k) {
        const auto to = [&](std::size_t j) { return (supports[k] - supports[j]).norm(); };
        further.rows.push_back({to(0), to(1), to(2), 0.0, 0.003});
    }
    for (AssetEntry& asset : project.assets)
        if (asset.id == "ballbars") asset.setup.values["further_supports"] = further;
    lengths.units = {Unit{}, Unit{}, Unit::of("mm")};
    for (int k = 0; k < 15; ++k) {
        const Eigen::Vector3d p(100.0 * (k % 5), 150.0 * (k / 5), 400.0 + 20.0 * k);
        for (std::size_t j = 0; j < supports.size(); ++j)
            lengths.rows.push_back(
                {"P" + std::to_string(k + 1), static_cast<double>(j + 1), (p - supports[j]).norm()});
    }
    setup_of(project, "paper").values = {
        {"ballbars", std::string("ballbars")}, {"evaluation", std::string("lengths")}, {"lengths", lengths}};
    const Readings readings = readings_of(project, "paper");
    ASSERT_TRUE(readings);
    ASSERT_EQ(readings->figures.size(), 3u);  // readings, lengths between supports, heights
    expect_campaigns(*readings, {1.0, 1.0, 1.0}, 16, 1);
    expect_campaigns(*readings, {1.8, 1.0, 1.0}, 17, 1);
}

/// Two cameras see the targets that a tracker knows much better. Disabled: in some campaigns the third and
/// fourth figure have a redundancy below 10, and targets enough for them take minutes.
TEST(PlainCampaigns, DISABLED_OfSensors) {
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
