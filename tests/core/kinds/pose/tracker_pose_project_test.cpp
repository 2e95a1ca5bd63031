// projects/tracker-pose.covaria: points measured by a network reach the pose in one joint propagation.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "core/base/resource_path.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace covaria::tracker_pose_project_test {
namespace {

struct TrackerPose {
    TrackerPose() : project(load_project(data_directory() / "projects/tracker-pose.covaria").project) {
        keep_one_pose("network");
        keep_one_pose("tracker-alone");
    }

    AnalysisEntry& analysis(const std::string& id) {
        for (AnalysisEntry& entry : project.analyses)
            if (entry.id == id) return entry;
        throw std::out_of_range(id);
    }
    covaria::Setup& asset(const std::string& id) {
        for (AssetEntry& entry : project.assets)
            if (entry.id == id) return entry.setup;
        throw std::out_of_range(id);
    }
    void keep_one_pose(const std::string& id) {
        std::get<SetupTable>(analysis(id).setup.values.at("poses")).rows.resize(1);
    }
    void set(const std::string& id, const std::string& key, double value, const char* unit) {
        asset(id).values[key] = Quantity{value, Unit::of(unit)};
    }

    std::shared_ptr<const PreparedAnalysis> prepare(const std::string& id) {
        problems = {};
        return made_analysis(project, id, problems);
    }
    UncertaintyResult first_order(const std::string& id) {
        analysis(id).options.method = Method::first_order;
        const auto prepared = prepare(id);
        if (!prepared) throw std::runtime_error(problems.items().front().message.english());
        return run_analysis(*prepared, {}).value();
    }
    std::string errors() const {
        std::string text;
        for (const Problem& problem : problems.items())
            if (problem.severity == Severity::error)
                text += problem.path + ": " + problem.message.english() + "\n";
        return text;
    }

    Project project;
    Problems problems;
};

Eigen::MatrixXd covariance_of(const InputSet& inputs) {
    const auto n = static_cast<Eigen::Index>(inputs.quantities.size());
    Eigen::MatrixXd F = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(inputs.components.size()));
    for (Eigen::Index i = 0; i < n; ++i)
        for (const Share& share : inputs.quantities[static_cast<std::size_t>(i)].shares) {
            const auto& component = inputs.components[share.component];
            F(i, static_cast<Eigen::Index>(share.component)) +=
                share.factor * component.distribution.standard_uncertainty();
        }
    return F * F.transpose();
}

/// The nests as targets of the model "points from sensors", with the network's sensors.
AnalysisEntry points_analysis(const InputSet& nests) {
    AnalysisEntry entry{.id = "points", .model = "points-from-sensors", .name = "Nests"};
    entry.setup.values["sensors"] =
        SetupTable{{Unit{}}, {{std::string("tracker")}, {std::string("total-station")}}};
    const Unit mm = Unit::of("mm");
    SetupTable targets{{Unit{}, mm, mm, mm, Unit{}}, {}};
    for (std::size_t i = 0; i < nests.quantities.size(); i += 3)
        targets.rows.push_back({nests.quantities[i].symbol, 1e3 * nests.quantities[i].offset,
                                1e3 * nests.quantities[i + 1].offset, 1e3 * nests.quantities[i + 2].offset,
                                false});
    entry.setup.values["targets"] = targets;
    entry.options.method = Method::first_order;
    return entry;
}

TEST(TrackerPose, NestsHaveTheCovarianceOfTheNetworkModel) {
    TrackerPose t;
    const auto pose = t.prepare("network");
    ASSERT_TRUE(pose) << t.errors();
    const Eigen::MatrixXd of_pose = covariance_of(pose->inputs);
    t.project.analyses.push_back(points_analysis(pose->inputs));
    const auto points = t.prepare("points");
    ASSERT_TRUE(points) << t.errors();
    const UncertaintyResult result = run_analysis(*points, {}).value();
    ASSERT_EQ(result.outputs.size(), 18u);
    const double largest = of_pose.diagonal().maxCoeff();
    for (Eigen::Index i = 0; i < 18; ++i)
        for (Eigen::Index j = 0; j < 18; ++j)
            EXPECT_NEAR(result.covariance(i, j), of_pose(i, j), 1e-7 * largest) << i << ' ' << j;
}

TEST(TrackerPose, WhereOneInstrumentStandsCancelsInTheRelativePose) {
    TrackerPose t;
    const UncertaintyResult known = t.first_order("tracker-alone");
    for (const char* key : {"u_station_x", "u_station_y", "u_station_z"}) t.set("tracker", key, 5.0, "mm");
    for (const char* key : {"u_station_omega", "u_station_phi", "u_station_kappa"})
        t.set("tracker", key, 60.0, "arcsec");
    const UncertaintyResult uncertain = t.first_order("tracker-alone");
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(uncertain.outputs[i].standard_uncertainty, known.outputs[i].standard_uncertainty,
                    1e-6 * known.outputs[i].standard_uncertainty)
            << known.outputs[i].quantity.symbol;
}

TEST(TrackerPose, TheTotalStationHelps) {
    TrackerPose t;
    const UncertaintyResult both = t.first_order("network"), alone = t.first_order("tracker-alone");
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_LT(both.outputs[i].standard_uncertainty, alone.outputs[i].standard_uncertainty);
}

TEST(TrackerPose, AnInstrumentSharesItsDeviationsInsideAndOutsideTheNetwork) {
    TrackerPose t;
    t.analysis("network").setup.values["moving_asset"] = std::string("tracker");
    const auto prepared = t.prepare("network");
    ASSERT_TRUE(prepared) << t.errors();
    std::size_t shared = 0;
    for (const UncertaintyComponent& component : prepared->inputs.components)
        shared += component.id == "tracker.scale";
    EXPECT_EQ(shared, 1u);
}

TEST(TrackerPose, ANestThatCannotBeLocalisedIsNamed) {
    TrackerPose t;
    for (const char* id : {"tracker", "total-station"})
        t.asset(id).values["kind"] = std::string("distance-meter");
    EXPECT_FALSE(t.prepare("network"));
    EXPECT_NE(t.errors().find("point b1 cannot be measured by Tracker and total station: it cannot be "
                              "localised from what Laser tracker, Total station read"),
              std::string::npos)
        << t.errors();
}

TEST(TrackerPose, ANestOutOfRangeIsNamed) {
    TrackerPose t;
    for (const char* id : {"tracker", "total-station"}) t.set(id, "view_farthest", 1.0, "m");
    EXPECT_FALSE(t.prepare("network"));
    EXPECT_NE(t.errors().find("no sensor of the network sees it"), std::string::npos) << t.errors();
}

TEST(TrackerPose, AnAssetThatRefersBackToItselfIsRefused) {
    TrackerPose t;
    std::get<SetupTable>(t.asset("network").values.at("sensors")).rows[0][0] = std::string("network");
    EXPECT_FALSE(t.prepare("network"));
    EXPECT_NE(t.errors().find("/assets/2/setup/sensors/rows/0/sensor: 'sensor' refers to the asset 'Tracker "
                              "and total station', "
                              "which refers back to this one"),
              std::string::npos)
        << t.errors();
}

}  // namespace
}  // namespace covaria::tracker_pose_project_test
