// A network of many instruments and targets, made from the trackers of lsm-network.covaria.
#pragma once

#include "core/base/resource_path.h"
#include "core/made/load_project.h"

namespace covaria::bench {

/// Laser trackers around a hall, targets on a grid in it.
inline Project large_network(int sensors, int targets) {
    Project project = load_project(data_directory() / "projects/lsm-network.covaria").project;
    const AssetEntry tracker = *project.find_asset("laser-tracker");
    AnalysisEntry analysis = *project.find_analysis("recommended");
    analysis.studies.clear();
    analysis.designs.clear();
    auto& rows_of_sensors = std::get<SetupTable>(analysis.setup.values.at("sensors")).rows;
    auto& rows_of_targets = std::get<SetupTable>(analysis.setup.values.at("targets")).rows;
    rows_of_sensors.clear();
    rows_of_targets.clear();
    analysis.setup.values.erase("distances");
    project.assets.clear();
    for (int s = 0; s < sensors; ++s) {
        AssetEntry& added = project.assets.emplace_back(tracker);
        added.id = added.name = "T" + std::to_string(s);
        PoseValue station;
        station.position = {2000.0 * (s % 10), s < sensors / 2 ? -3000.0 : 13000.0, 500.0 * (s % 3)};
        station.angles = {0.0, 0.0, s < sensors / 2 ? 90.0 : -90.0};
        added.setup.values["station"] = station;
        rows_of_sensors.push_back({added.id});
    }
    for (int t = 0; t < targets; ++t)
        rows_of_targets.push_back(
            {"P" + std::to_string(t), 500.0 * (t % 40), 400.0 * (t / 40), 20.0 * (t % 7), false});
    project.analyses = {analysis};
    return project;
}

}  // namespace covaria::bench
