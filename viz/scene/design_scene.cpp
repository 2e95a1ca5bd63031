#include "viz/scene/design_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/text/head_with_unit.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "viz/scene/build_parts.h"
#include "viz/scene/near_part.h"

namespace covaria {

namespace {

constexpr double point_radius = 0.011;  // fractions of the extent of what is drawn
constexpr double near_point = 0.004;    ///< places of a path so near to the one before are left out
constexpr double path_radius = 0.0022;
constexpr int most_names = 3;  ///< limit of names of candidates that were not chosen

double extent_of(const DesignResult& design) {
    Eigen::AlignedBox3d box;
    for (const DesignGain& gain : design.gains)
        if (gain.place) box.extend(*gain.place);
    for (const DesignTrack& track : design.places.tracks) {
        for (const Eigen::Vector3d& corner : track.region) box.extend(corner);
        for (const Eigen::Vector3d& place : track.path) box.extend(place);
        box.extend(track.chosen);
    }
    for (const LayoutPoint& point : design.places.layout.points) box.extend(point.p_W);
    for (const LayoutBody& body : design.places.layout.bodies)
        if (body.outline_W.empty()) box.extend(body.X_WB.translation());
    const bool is_drawn = !box.isEmpty() && detail::is_near(box.min()) && detail::is_near(box.max());
    return is_drawn ? box.diagonal().norm() : 0.0;
}

void scale_colours(SceneMap& map) {
    map.low = std::numeric_limits<double>::infinity();
    map.high = -map.low;
    for (const double value : map.values) {
        if (!std::isfinite(value)) continue;
        map.low = std::min(map.low, value);
        map.high = std::max(map.high, value);
    }
    if (!(map.low <= map.high)) map.low = map.high = 0.0;
    if (!(map.high > map.low)) map.high = map.low + std::max(1e-12, 1e-3 * std::abs(map.low));
}

/// The rows of the table, larger where they were chosen.
SceneMap map_of_rows(const DesignResult& design, double extent, const DocumentLanguage& in) {
    SceneMap map;
    map.title = to_unicode(head_with_unit(in.say(tell<"gain">()), Unit::of("%")));
    map.radius = point_radius * extent;
    for (const DesignGain& gain : design.gains) {
        if (!gain.place) continue;
        map.positions.push_back(*gain.place);
        map.values.push_back(gain.gain ? 100.0 * *gain.gain : std::numeric_limits<double>::quiet_NaN());
        map.marked.push_back(gain.kept);
    }
    map.shown.assign(map.positions.size(), true);
    scale_colours(map);
    return map;
}

/// The places of the best so far, coloured by the objective, with the way between them.
SceneMap map_of_paths(const DesignResult& design, double extent, const DocumentLanguage& in) {
    SceneMap map;
    map.title = in.say_declared(design.objective_words);
    map.radius = 0.6 * point_radius * extent;
    map.way_radius = path_radius * extent;
    for (const DesignTrack& track : design.places.tracks) {
        bool first = true;
        for (std::size_t i = 0; i < track.path.size(); ++i) {
            const bool last = i + 1 == track.path.size();
            if (!first && !last && (track.path[i] - map.positions.back()).norm() < near_point * extent)
                continue;
            if (!first) map.ways.push_back({map.positions.size() - 1, map.positions.size()});
            map.positions.push_back(track.path[i]);
            map.values.push_back(track.objectives[i]);
            map.marked.push_back(last);
            first = false;
        }
    }
    map.shown.assign(map.positions.size(), true);
    scale_colours(map);
    return map;
}

SceneLink edge(const std::string& id, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
               bool is_dashed) {
    SceneLink link;
    link.item.id = id;
    link.item.position = (from + to) / 2;
    link.from = from;
    link.to = to;
    link.is_dashed = is_dashed;
    return link;
}

/// Corners that differ in one bit are joined.
void add_edges(Scene& scene, const std::string& id, const std::vector<Eigen::Vector3d>& corners,
               bool is_dashed) {
    for (std::size_t a = 0; a < corners.size(); ++a)
        for (std::size_t b = a + 1; b < corners.size(); ++b)
            if (std::has_single_bit(a ^ b))
                scene.links.push_back(
                    edge(id + ":" + std::to_string(scene.links.size()), corners[a], corners[b], is_dashed));
}

void add_tracks(Scene& scene, const DesignResult& design, double extent, const DocumentLanguage& in) {
    for (const DesignTrack& track : design.places.tracks) {
        add_edges(scene, "region:" + track.name, track.region, true);
        const auto add = [&](const Message& words, const Eigen::Vector3d& place, double above, int priority) {
            const std::string said = in.say(words);
            const std::string label = design.places.tracks.size() > 1 ? track.name + ": " + said : said;
            scene.labels.push_back({label, place, above, Role::text, priority});
            return label;
        };
        if (track.before) {
            ScenePoint before;
            before.radius = 0.7 * point_radius * extent;
            before.item = {.id = "before:" + track.name,
                           .name = add(tell<"before">(), *track.before, before.radius, 450),
                           .position = *track.before};
            scene.points.push_back(std::move(before));
        }
        add(tell<"best: %1">(typeset_number(format_significant(design.objective, 4), scene.numbers)),
            track.chosen, 2.0 * point_radius * extent, 500);
    }
}

void add_obstacles(Scene& scene, const DesignResult& design) {
    for (const DesignObstacle& box : design.places.obstacles) {
        if (!detail::is_near(box.low) || !detail::is_near(box.high)) continue;
        std::vector<Eigen::Vector3d> corners;
        for (int i = 0; i < 8; ++i) {
            Eigen::Vector3d corner = box.low;
            for (int axis = 0; axis < 3; ++axis)
                if ((i >> axis) & 1) corner[axis] = box.high[axis];
            corners.push_back(corner);
        }
        add_edges(scene, "obstacle:" + box.name, corners, false);
        scene.labels.push_back({box.name, corners.back(), 0.0, Role::quiet_text, 300});
    }
}

/// Names the best few that were not chosen; chosen ones have the names of their instruments.
void name_rows(Scene& scene, const DesignResult& design, const DocumentLanguage& in) {
    std::vector<const DesignGain*> others;
    for (const DesignGain& gain : design.gains)
        if (gain.place && gain.gain && !gain.kept) others.push_back(&gain);
    std::ranges::stable_sort(others,
                             [](const DesignGain* a, const DesignGain* b) { return *a->gain > *b->gain; });
    for (std::size_t i = 0; i < std::min<std::size_t>(others.size(), most_names); ++i)
        scene.labels.push_back(
            {running_text(in.say(others[i]->name)) + ": " +
                 typeset_number(format_significant(100.0 * *others[i]->gain, 2), scene.numbers) + " %",
             *others[i]->place, scene.map->radius, Role::quiet_text, 440});
}

}  // namespace

Scene design_scene(const DesignResult& design, const SceneOptions& options) {
    const DocumentLanguage& in = options.language;
    SceneOptions plain = options;
    plain.ellipsoids = plain.clouds = plain.wall_histograms = false;
    SceneSource source{&design.places.layout, nullptr, nullptr, nullptr, design.name};
    const double extent = extent_of(design);
    const bool of_rows =
        std::ranges::any_of(design.gains, [](const DesignGain& gain) { return gain.place.has_value(); });
    if (!stands_in_space(design) || !(extent > 0.0)) {
        Scene scene = build_scene(source, plain);
        scene.caption = in.say(design.found ? tell<"nothing that this design chooses stands in space">()
                                            : tell<"nothing that was tried has a result">());
        return scene;
    }
    const SceneMap map = of_rows ? map_of_rows(design, extent, in) : map_of_paths(design, extent, in);
    source.map = &map;
    Scene scene = build_scene(source, plain);
    add_tracks(scene, design, extent, in);
    add_obstacles(scene, design);
    if (of_rows) {
        name_rows(scene, design, in);
        scene.legend.push_back({LegendMark::none, Role::quiet_text,
                                in.say(tell<"candidates; the larger %1 of %2 are chosen">(
                                    design.rows.size(), design.candidates))});
        scene.caption = in.say(tell<"gain: by how much the uncertainty is smaller with this candidate than "
                                    "without it, the others as chosen">());
    } else {
        scene.legend.push_back(
            {LegendMark::none, Role::quiet_text, in.say(tell<"best so far, in the order of the search">())});
        scene.caption = in.say(tell<"dashed: where it may stand">());
    }
    detail::add_axes(scene);
    return scene;
}

}  // namespace covaria
