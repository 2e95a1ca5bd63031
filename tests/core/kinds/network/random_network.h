// Networks of trackers and cameras anywhere about random targets, with readings as their figures scatter
// them.
#pragma once

#include <random>

#include "core/base/resource_path.h"
#include "core/math/rotation.h"
#include "tests/core/made.h"

namespace covaria::random_network {

struct Instrument {
    Eigen::Vector3d position;  ///< mm
    Eigen::Vector3d angles;    ///< Z-Y-X, rad
    double u_position = 0.0;   ///< mm
    double u_angle = 0.0;      ///< arcsec
    bool camera = false;
};

/// The truth that a network is made from: instruments and targets, readings of them, and the figures stated.
struct World {
    std::vector<Instrument> instruments;
    std::vector<Eigen::Vector3d> targets;                  ///< mm
    std::vector<std::vector<std::array<double, 3>>> read;  ///< of a target by an instrument: mm, rad, rad
    std::vector<Eigen::Vector3d> nominal;                  ///< positions stated for the targets, mm
    std::vector<Eigen::Vector3d> stated;                   ///< positions of the instruments, mm
};

constexpr double arcsec = std::numbers::pi / 180.0 / 3600.0;
constexpr double u_distance = 0.01, u_direction = 2.0;  // mm, arcsec
constexpr double u_camera = 20.0;                       // arcsec

inline std::array<double, 3> seen(const Instrument& instrument, const Eigen::Vector3d& target) {
    const Eigen::Matrix3d R = rotation_from_zyx<double>(instrument.angles);
    const Eigen::Vector3d v = R.transpose() * (target - instrument.position);
    return {v.norm(), std::atan2(v.y(), v.x()), std::atan2(v.z(), v.head<2>().norm())};
}

/// The first instrument stands exactly where it is said to stand; cameras look at the targets.
inline World world(std::mt19937_64& engine, std::size_t instruments, std::size_t targets, double u_position,
                   double u_angle) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::normal_distribution<double> normal;
    World made;
    for (std::size_t t = 0; t < targets; ++t)
        made.targets.emplace_back(2000.0 * unit(engine), 2000.0 * unit(engine), 800.0 * unit(engine));
    for (std::size_t s = 0; s < instruments; ++s) {
        const double about = 2.0 * std::numbers::pi * (static_cast<double>(s) + 0.3 * unit(engine)) /
                             static_cast<double>(instruments);
        Instrument& added = made.instruments.emplace_back();
        added.position = {6000.0 * std::cos(about), 6000.0 * std::sin(about), 1500.0 * unit(engine)};
        added.angles = {0.05 * unit(engine), 0.05 * unit(engine),
                        about + std::numbers::pi + 0.2 * unit(engine)};
        added.camera = s > 1 && s % 3 == 2;
        if (s == 0) continue;
        added.u_position = u_position;
        added.u_angle = u_angle;
    }
    made.nominal = made.targets;
    for (const Instrument& i : made.instruments) made.stated.push_back(i.position);
    for (const Eigen::Vector3d& target : made.targets) {
        auto& row = made.read.emplace_back();
        for (const Instrument& i : made.instruments) {
            std::array<double, 3> reading = seen(i, target);
            reading[0] += u_distance * normal(engine);
            for (const std::size_t k : {1u, 2u})
                reading[k] += (i.camera ? u_camera : u_direction) * arcsec * normal(engine);
            row.push_back(reading);
        }
    }
    return made;
}

inline Project project_of(const World& world, const std::string& weights = "with-stations") {
    Project project = load_project(data_directory() / "projects/lsm-network.covaria").project;
    const AssetEntry pattern = *project.find_asset("laser-tracker");
    AnalysisEntry analysis = *project.find_analysis("recommended");
    project.assets.clear();
    analysis.studies.clear();
    analysis.designs.clear();
    analysis.options.method = Method::first_order;
    SetupTable sensors{{Unit{}}, {}},
        readings{{Unit{}, Unit{}, Unit::of("mm"), Unit::of("rad"), Unit::of("rad")}, {}};
    auto& targets = std::get<SetupTable>(analysis.setup.values.at("targets")).rows;
    targets.clear();
    for (std::size_t s = 0; s < world.instruments.size(); ++s) {
        const Instrument& instrument = world.instruments[s];
        AssetEntry& added = project.assets.emplace_back(pattern);
        added.id = added.name = "S" + std::to_string(s);
        const Eigen::Vector3d& at = world.stated[s];
        added.setup.values = {};
        auto& values = added.setup.values;
        values["station"] =
            PoseValue{.position = {at.x(), at.y(), at.z()},
                      .angles = {instrument.angles[0], instrument.angles[1], instrument.angles[2]},
                      .angle_unit = Unit::of("rad")};
        values["kind"] = std::string(instrument.camera ? "camera" : "tracker");
        if (!instrument.camera) values["distance_constant"] = Quantity{u_distance, Unit::of("mm")};
        for (const char* key : {"angle_azimuth", "angle_elevation"})
            values[key] = Quantity{instrument.camera ? u_camera : u_direction, Unit::of("arcsec")};
        for (const char* key : {"u_station_x", "u_station_y", "u_station_z"})
            values[key] = Quantity{instrument.u_position, Unit::of("mm")};
        for (const char* key : {"u_station_omega", "u_station_phi", "u_station_kappa"})
            values[key] = Quantity{instrument.u_angle, Unit::of("arcsec")};
        sensors.rows.push_back({added.id});
    }
    for (std::size_t t = 0; t < world.targets.size(); ++t) {
        const std::string name = "P" + std::to_string(t);
        const Eigen::Vector3d& at = world.nominal[t];
        targets.push_back({name, at.x(), at.y(), at.z(), false});
        for (std::size_t s = 0; s < world.instruments.size(); ++s) {
            const auto& [distance, azimuth, elevation] = world.read[t][s];
            readings.rows.push_back({name, "S" + std::to_string(s),
                                     world.instruments[s].camera ? SetupCell() : SetupCell(distance), azimuth,
                                     elevation});
        }
    }
    analysis.setup.values["sensors"] = std::move(sensors);
    analysis.setup.values["readings"] = std::move(readings);
    analysis.setup.values["evaluation"] = std::string("a-posteriori");
    analysis.setup.values["weights"] = weights;
    analysis.setup.values.erase("distances");
    project.analyses = {analysis};
    return project;
}

/// Estimates and standard uncertainties, m.
struct Found {
    std::vector<double> y, u;
    std::string words;  ///< warnings
};

inline Found found_by(const Project& project) {
    Problems problems;
    const auto prepared = made_analysis(project, project.analyses.front().id, problems);
    Found found;
    for (const Problem& p : problems.items()) found.words += p.message.english() + "\n";
    if (!prepared) {
        ADD_FAILURE() << found.words;
        return found;
    }
    const auto result = run_analysis(*prepared, {});
    for (const OutputResult& output : result->outputs) {
        found.y.push_back(output.estimate);
        found.u.push_back(output.standard_uncertainty);
    }
    return found;
}

}  // namespace covaria::random_network
