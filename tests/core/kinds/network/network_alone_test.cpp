// An instrument in a network of its own equals the instrument alone: deviation by deviation, for every sensor
// of the library and some with all figures stated, at random stations, of random targets. Networks
// of several against plain linear algebra. The cases of ../shared/cases that were wrong.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "core/kinds/instruments/sensor.h"
#include "core/kinds/points/point_uncertainty.h"
#include "core/made/library.h"
#include "tests/core/made.h"

namespace covaria::network_alone_test {
namespace {

using Generator = std::mt19937;

double uniform(Generator& g, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(g);
}

AssetEntry entry(const std::string& id, const std::string& kind, Setup setup) {
    AssetEntry made;
    made.id = id;
    made.kind = kind;
    made.name = id;
    made.setup = std::move(setup);
    return made;
}

AssetEntry network_of(const std::string& id, const std::vector<std::string>& sensors,
                      const std::string& weights) {
    SetupTable table;
    table.units = {Unit{}};
    for (const std::string& sensor : sensors) table.rows.push_back({sensor});
    return entry(id, "sensor-network", {{{"sensors", table}, {"weights", weights}}});
}

void place(Setup& setup, Generator& g) {
    PoseValue station;
    for (double& x : station.position) x = uniform(g, -3000, 3000);
    for (double& a : station.angles) a = uniform(g, -170, 170);
    setup.values["station"] = station;
    for (const char* key : {"u_station_x", "u_station_y", "u_station_z"})
        setup.values[key] = Quantity{uniform(g, 0.005, 0.05), Unit::of("mm")};
    for (const char* key : {"u_station_omega", "u_station_phi", "u_station_kappa"})
        setup.values[key] = Quantity{uniform(g, 0.5, 3), Unit::of("arcsec")};
    for (const char* key : {"view_nearest", "view_farthest", "view_azimuth", "view_elevation"})
        setup.values.erase(key);
}

/// A tracker with everything that its readings can share; the distance without a figure of its own if `zero`.
Setup full_tracker(Generator& g, bool zero, bool correlated) {
    Setup setup{{{"kind", std::string("tracker")},
                 {"distance_constant", Quantity{zero ? 0.0 : 0.01, Unit::of("mm")}},
                 {"angle_azimuth", Quantity{6, Unit::of("urad")}},
                 {"angle_elevation", Quantity{5, Unit::of("urad")}},
                 {"across_constant", Quantity{0.015, Unit::of("mm")}},
                 {"u_scale", Quantity{2, Unit::of("ppm")}},
                 {"u_zero", Quantity{0.01, Unit::of("mm")}},
                 {"u_index", Quantity{1, Unit::of("arcsec")}},
                 {"u_collimation", Quantity{2, Unit::of("arcsec")}},
                 {"u_axis_tilt", Quantity{2, Unit::of("arcsec")}},
                 {"u_beam_offset", Quantity{0.02, Unit::of("mm")}},
                 {"u_refraction", Quantity{0.1, Unit::of("1")}}}};
    place(setup, g);
    if (correlated)
        setup.values["station_correlation"] =
            SetupTable{{Unit{}, Unit{}, Unit{}}, {{std::string("y_0"), std::string("kappa"), 0.7}}};
    return setup;
}

std::vector<AssetEntry> sensors_under_test(Generator& g) {
    std::vector<AssetEntry> sensors;
    for (const LibraryItem& item : load_library().items)
        if (item.asset.kind == "spherical-instrument") {
            sensors.push_back(item.asset);
            place(sensors.back().setup, g);
        }
    for (const bool zero : {false, true})
        for (const bool correlated : {false, true})
            sensors.push_back(entry("", "spherical-instrument", full_tracker(g, zero, correlated)));
    for (std::size_t i = 0; i < sensors.size(); ++i) sensors[i].id = "s" + std::to_string(i);
    return sensors;
}

/// Random targets about the station; one just outside of where azimuths are undefined, one inside, one above.
std::vector<Eigen::Vector3d> targets_of(const SensorSource& sensor, Generator& g) {
    std::vector<Eigen::Vector3d> targets;
    for (int i = 0; i < 5; ++i) targets.push_back({uniform(g, -4, 4), uniform(g, -4, 4), uniform(g, -4, 4)});
    const Eigen::Isometry3d X_WS = sensor.station().X_WS();
    for (const double off : {3.01e-3, 2.99e-3, 0.0}) targets.push_back(X_WS * Eigen::Vector3d(off, 0, 3));
    return targets;
}

/// u times direction for every target, by identity: shared components by their owner and id, readings by
/// target.
using Deviations = std::map<std::string, std::vector<Eigen::Vector3d>>;

Deviations deviations_of(const Asset& asset, const std::string& id,
                         const std::vector<Eigen::Vector3d>& targets) {
    Deviations found;
    for (const JointDeviation& d : offers<PointUncertaintySource>(&asset)->joint_deviations(targets)) {
        std::string key = (d.owner.empty() ? id : d.owner) + "." + d.id;
        if (d.point)  // "range", or "s3.distance"
            key = "reading of " + std::to_string(*d.point) + ", " +
                  (d.id == "range"                       ? id + ".distance"
                   : d.id.find('.') == std::string::npos ? id + "." + d.id
                                                         : d.id);
        std::vector<Eigen::Vector3d>& moves = found[key];
        EXPECT_TRUE(moves.empty()) << key << " is there twice";
        for (const Eigen::Vector3d& direction : d.directions)
            moves.push_back(d.component.distribution.standard_uncertainty() * direction);
    }
    return found;
}

TEST(NetworkOfOne, EqualsTheInstrumentAlone) {
    Generator g(7);
    const std::vector<AssetEntry> sensors = sensors_under_test(g);
    ASSERT_GE(sensors.size(), 12u);
    std::size_t compared = 0;
    for (const AssetEntry& sensor : sensors)
        for (const char* weights : {"with-stations", "observations"}) {
            Project project;
            project.assets = {sensor, network_of("n", {sensor.id}, weights)};
            Problems problems;
            const AssetLibrary assets = made_assets(project, problems);
            ASSERT_NE(assets.find("n"), nullptr) << sensor.name;
            const Asset& alone = *assets.find(sensor.id)->asset;
            if (!offers<PointUncertaintySource>(&alone)) continue;
            const auto targets = targets_of(*offers<SensorSource>(&alone), g);
            const Deviations one = deviations_of(alone, sensor.id, targets),
                             other = deviations_of(*assets.find("n")->asset, "n", targets);
            ASSERT_EQ(one.size(), other.size()) << sensor.name;
            for (const auto& [key, moves] : one) {
                ASSERT_TRUE(other.contains(key)) << key;
                for (std::size_t t = 0; t < targets.size(); ++t)
                    EXPECT_LT((moves[t] - other.at(key)[t]).norm(), 1e-12)
                        << sensor.name << ", " << key << ", target " << t;
            }
            ++compared;
        }
    EXPECT_GE(compared, 16u);
}

/// Deviations displace a target alike on both sides of the border at which azimuths become displacements.
TEST(NetworkOfOne, NothingJumpsNearTheZenith) {
    Generator g(3);
    Project project;
    project.assets = {entry("t", "spherical-instrument", full_tracker(g, false, false))};
    Problems problems;
    const AssetLibrary assets = made_assets(project, problems);
    const Asset& t = *assets.find("t")->asset;
    const Eigen::Isometry3d X_WS = offers<SensorSource>(&t)->station().X_WS();
    const auto at = [&](double off) { return deviations_of(t, "t", {X_WS * Eigen::Vector3d(off, 0, 3)}); };
    const Deviations outside = at(3.001e-3), inside = at(2.999e-3), above = at(0.0);
    for (const auto& [key, moves] : outside) {
        EXPECT_LT((moves[0] - inside.at(key)[0]).norm(), 2e-3 * moves[0].norm() + 1e-10) << key;
        EXPECT_LT((moves[0] - above.at(key)[0]).norm(), 2e-3 * moves[0].norm() + 1e-7) << key;
    }
    EXPECT_NEAR(above.at("t.collimation")[0].norm(), 3 * 2 / 206264.8, 1e-9);
    EXPECT_NEAR(above.at("t.beam_offset")[0].norm(), 0.02e-3, 1e-12);
}

// --- several instruments, against plain linear algebra and differences

double angle_between(double a, double b) {
    return std::remainder(a - b, 2 * std::numbers::pi);
}

std::array<double, 3> readings_at(const Station& station, const Eigen::Vector3d& p) {
    const Eigen::Vector3d v = station.X_WS().inverse() * p;
    return {v.norm(), std::atan2(v.y(), v.x()), std::atan2(v.z(), std::hypot(v.x(), v.y()))};
}

/// Derivatives of a reading by the quantity that `move` changes by `step`.
template <class Move>
std::array<double, 3> differences(double step, const Move& move) {
    const auto high = move(step), low = move(-step);
    return {(high[0] - low[0]) / (2 * step), angle_between(high[1], low[1]) / (2 * step),
            (high[2] - low[2]) / (2 * step)};
}

/// Covariance of all points with all their correlations: (Jᵀ C⁻¹ J)⁻¹, or G C Gᵀ for other weights.
Eigen::MatrixXd slow_covariance(const std::vector<const SensorSource*>& sensors,
                                const std::vector<Eigen::Vector3d>& points, bool with_stations) {
    const auto rows = static_cast<Eigen::Index>(3 * sensors.size() * points.size());
    const auto columns = static_cast<Eigen::Index>(3 * points.size());
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows, columns), U = Eigen::MatrixXd::Zero(rows, rows);
    Eigen::MatrixXd F = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(8 * sensors.size()));
    Eigen::Index row = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
        for (std::size_t s = 0; s < sensors.size(); ++s, row += 3) {
            const Station& station = sensors[s]->station();
            const Eigen::Vector3d v = station.X_WS().inverse() * points[p];
            const auto base = static_cast<Eigen::Index>(8 * s);
            for (int c = 0; c < 3; ++c) {
                const auto by = differences(1e-5, [&](double h) {
                    return readings_at(station, points[p] + h * Eigen::Vector3d::Unit(c));
                });
                for (int i = 0; i < 3; ++i)
                    J(row + i, static_cast<Eigen::Index>(3 * p) + c) = by[static_cast<std::size_t>(i)];
            }
            for (std::size_t c = 0; c < 6; ++c) {
                const auto by = differences(1e-5, [&](double h) {
                    Station moved = station;
                    moved.coordinates[c] += h;
                    return readings_at(moved, points[p]);
                });
                const double u = sensors[s]->station_components()[c].distribution.standard_uncertainty();
                for (int i = 0; i < 3; ++i)
                    F(row + i, base + static_cast<Eigen::Index>(c)) = by[static_cast<std::size_t>(i)] * u;
            }
            F(row, base + 6) = 2e-6 * v.norm();                                           // scale
            F(row + 1, base + 7) = 2 / 206264.806 * v.norm() / std::hypot(v.x(), v.y());  // collimation
            for (int i = 0; i < 3; ++i)
                U(row + i, row + i) = std::pow(sensors[s]
                                                   ->reading(observables[static_cast<std::size_t>(i)], v)
                                                   .distribution.standard_uncertainty(),
                                               2);
        }
    const Eigen::MatrixXd C = U + F * F.transpose();
    const Eigen::MatrixXd W = (with_stations ? C : U).inverse();
    const Eigen::MatrixXd G = (J.transpose() * W * J).inverse() * J.transpose() * W;
    return G * C * G.transpose();
}

Eigen::MatrixXd covariance_of(const Deviations& deviations, std::size_t points) {
    Eigen::MatrixXd C =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * points), static_cast<Eigen::Index>(3 * points));
    for (const auto& [key, moves] : deviations) {
        Eigen::VectorXd d(C.rows());
        for (std::size_t p = 0; p < points; ++p) d.segment<3>(static_cast<Eigen::Index>(3 * p)) = moves[p];
        C += d * d.transpose();
    }
    return C;
}

TEST(Networks, EqualPlainLeastSquares) {
    Generator g(11);
    for (int set_up = 0; set_up < 4; ++set_up)
        for (const char* weights : {"with-stations", "observations"}) {
            Project project;
            for (const char* id : {"a", "b", "c"}) {
                covaria::Setup setup = full_tracker(g, false, false);
                for (const char* key : {"u_zero", "u_index", "u_axis_tilt", "u_beam_offset", "u_refraction"})
                    setup.values.erase(key);
                project.assets.push_back(entry(id, "spherical-instrument", setup));
            }
            project.assets.push_back(network_of("n", {"a", "b", "c"}, weights));
            Problems problems;
            const AssetLibrary assets = made_assets(project, problems);
            std::vector<const SensorSource*> sensors;
            for (const char* id : {"a", "b", "c"}) sensors.push_back(offers<SensorSource>(assets.find(id)));
            std::vector<Eigen::Vector3d> points;
            for (int i = 0; i < 4; ++i)
                points.push_back({uniform(g, -4, 4), uniform(g, -4, 4), uniform(g, -4, 4)});
            Deviations found;
            for (const JointDeviation& d :
                 offers<PointUncertaintySource>(assets.find("n")->asset)->joint_deviations(points))
                for (const Eigen::Vector3d& direction : d.directions)
                    found[d.owner + "." + d.id + (d.point ? std::to_string(*d.point) : "")].push_back(
                        d.component.distribution.standard_uncertainty() * direction);
            const Eigen::MatrixXd C = covariance_of(found, points.size());
            const Eigen::MatrixXd slow =
                slow_covariance(sensors, points, std::string(weights) == "with-stations");
            EXPECT_LT((C - slow).norm(), 1e-5 * slow.norm()) << set_up << ", " << weights;
        }
}

// --- a figure of 0

/// Largest variance of the points relative to those of the other covariance.
double largest_ratio(const Eigen::MatrixXd& C, const Eigen::MatrixXd& other) {
    return C.diagonal().cwiseQuotient(other.diagonal()).maxCoeff();
}

TEST(Networks, AFigureOfZeroCountsAsTheLimitOfASmallOne) {
    Generator g(5);
    Project project;
    project.assets = {entry("z", "spherical-instrument", full_tracker(g, true, false)),
                      entry("s", "spherical-instrument", full_tracker(g, false, false)),
                      network_of("n", {"z", "s"}, "with-stations")};
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 4; ++i) points.push_back({uniform(g, -4, 4), uniform(g, -4, 4), uniform(g, -4, 4)});
    const auto covariance = [&](const std::string& id, double figure_mm) {
        project.assets[0].setup.values["distance_constant"] = Quantity{figure_mm, Unit::of("mm")};
        Problems problems;
        const AssetLibrary assets = made_assets(project, problems);
        return covariance_of(deviations_of(*assets.find(id)->asset, id, points), points.size());
    };
    const Eigen::MatrixXd network = covariance("n", 0.0), small = covariance("n", 1e-5);
    EXPECT_LE(largest_ratio(network, covariance("z", 0.0)), 1.0 + 1e-9) << "more readings, not less certain";
    EXPECT_LE(largest_ratio(network, covariance("n", 1e-3)), 1.0 + 1e-9);
    EXPECT_LT((network - small).norm(), 1e-4 * small.norm());
}

// --- the cases

struct Case {
    explicit Case(const std::string& name)
        : project(load_project(COVARIA_SOURCE_DIR "/tests/data/cases/" + name + ".covaria").project) {}

    UncertaintyResult run(const std::string& id, std::uint64_t trials) {
        for (AnalysisEntry& analysis : project.analyses) {
            analysis.options.method = trials == 0 ? Method::first_order : Method::monte_carlo;
            if (trials > 0) analysis.options.trials = trials;
        }
        problems = {};
        const auto prepared = made_analysis(project, id, problems);
        if (!prepared) throw std::runtime_error(problems.items().front().message.english());
        return *run_analysis(*prepared, {});
    }
    /// Standard uncertainties in mm (or 1e-3 rad).
    std::vector<double> u(const std::string& id, std::uint64_t trials = 0) {
        std::vector<double> values;
        for (const OutputResult& output : run(id, trials).outputs)
            values.push_back(1e3 * output.standard_uncertainty);
        return values;
    }

    Project project;
    Problems problems;
};

TEST(Cases, StationsHaveOneSign) {
    Case sign("sign-shipped");
    const auto alone = sign.u("alone"), as_network = sign.u("as-net");
    for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_NEAR(alone[i], as_network[i], 1e-7) << i;
    const double right[] = {.0518, .0469, .0183};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(alone[i], right[i], 2e-4) << i;
}

TEST(Cases, NothingVanishesAtTheZenith) {
    Case zenith("zen");
    for (const char* id : {"outside", "inside"}) {
        EXPECT_NEAR(zenith.u(id)[1], .0520, 1e-4) << id;
        EXPECT_NEAR(zenith.u(id, 100'000)[1], .0520, .0520 * 4 * std::sqrt(.5 / 100'000) + 5e-5) << id;
    }
}

TEST(Cases, AReadingWithoutAFigureOfItsOwnCounts) {
    Case zero("zerofig");
    const auto alone = zero.u("alone"), network = zero.u("network");
    EXPECT_NEAR(alone[0], .0087, 1e-4);
    for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_LE(network[i], alone[i] * (1 + 1e-9)) << i;
}

TEST(Cases, NoTrialIsLostToTheIteration) {
    Case cameras("cam0_0105");
    constexpr std::uint64_t trials = 100'000;
    const UncertaintyResult with = cameras.run("nl", trials), without = cameras.run("nlo", trials);
    EXPECT_EQ(with.failed_trials, 0u);
    EXPECT_EQ(without.failed_trials, 0u);
    EXPECT_NEAR(1e3 * with.outputs[0].standard_uncertainty, 380, 380 * 4 * std::sqrt(2.0 / trials));
    for (std::size_t i = 0; i < with.outputs.size(); ++i)  // no uncertain stations: the same estimator
        EXPECT_NEAR(with.outputs[i].standard_uncertainty, without.outputs[i].standard_uncertainty,
                    1e-6 * without.outputs[i].standard_uncertainty)
            << i;
}

TEST(Cases, AContradictionIsWarnedOf) {
    Case blunder("blunder");
    Problems problems;
    problems.take(MadeProject::make(blunder.project)->problems(), "");
    ASSERT_FALSE(problems.empty());
    const std::string& message = problems.items().front().message.english();
    EXPECT_NE(message.find("Chi-square"), std::string::npos) << message;
    EXPECT_NE(message.find("55 degrees of freedom"), std::string::npos) << message;
}

}  // namespace
}  // namespace covaria::network_alone_test
