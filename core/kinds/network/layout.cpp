// Layout of sensors, targets and sight lines of "points from sensors" for the scene.
#include "core/base/name.h"
#include "core/kinds/network/setup.h"

namespace covaria::network {

namespace {

constexpr std::size_t most_sight_lines = 400;  ///< more could not be told apart in one picture

}  // namespace

Layout network_layout(const NetworkSetup& setup, std::span<const double> x) {
    Layout layout;
    std::vector<Eigen::Vector3d> stations;
    for (std::size_t s = 0; s < setup.sensors.size(); ++s) {
        const Sensor& sensor = setup.sensors[s];
        Station station = sensor->station();
        const std::size_t first = setup.station_input(0, s);
        for (std::size_t i = 0; i < 6; ++i) station.coordinates[i] = x[first + i];
        const Eigen::Isometry3d X = station.X_WS();
        stations.push_back(X.translation());
        const LayoutSource source = as_part(sensor.asset->layout(), sensor.id).bodies.front().source;
        layout.bodies.push_back({.name = sensor.name,
                                 .kind = BodyKind::instrument,
                                 .X_WB = X,
                                 .glyph = sensor->glyph(),
                                 .source = source});
        layout.points.push_back({.name = sensor.name,
                                 .kind = PointKind::station,
                                 .p_W = X.translation(),
                                 .source = source,
                                 .inputs = {{first, first + 1, first + 2}}});
    }
    for (const Sensor& sensor : setup.sensors)  // edges of its field of view
        for (const LayoutLink& link : sensor.asset->layout().links) layout.links.push_back(link);
    for (const TargetFrame& frame : setup.frames)
        layout.frames.push_back({.name = frame.name, .X_WF = frame_of(setup, frame), .group = frame.name});
    std::size_t sight_lines = 0;
    for (const Target& target : setup.targets) sight_lines += target.sights.size();
    for (std::size_t t = 0; t < setup.targets.size(); ++t) {
        const Target& target = setup.targets[t];
        layout.points.push_back(
            {.name = target.name,
             .kind = PointKind::target,
             .p_W = target.nominal,
             .source = {network_fields().place(&StatedNetwork::targets, t), !setup.measured},
             .outputs = {{3 * t, 3 * t + 1, 3 * t + 2}}});
        for (const Sight& sight : target.sights)
            layout.links.push_back({.name = setup.sensors[sight.sensor].name + " – " + target.name,
                                    .kind = LinkKind::sight_line,
                                    .from_W = stations[sight.sensor],
                                    .to_W = target.nominal,
                                    .group = sight_lines > most_sight_lines ? target.name : ""});
    }
    const auto add_dimension = [&](const Name& name, std::size_t from, std::size_t to) {
        layout.links.push_back({.name = name,
                                .kind = LinkKind::dimension,
                                .from_W = setup.targets[from].nominal,
                                .to_W = setup.targets[to].nominal});
    };
    for (const Distance& d : setup.distances)
        add_dimension(setup.targets[d.from].name + " – " + setup.targets[d.to].name, d.from, d.to);
    for (const ScaleBar& bar : setup.bars)
        add_dimension(
            own_name<"scale bar %1">(setup.targets[bar.from].name + " – " + setup.targets[bar.to].name),
            bar.from, bar.to);
    return layout;
}

}  // namespace covaria::network
