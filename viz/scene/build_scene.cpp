// build_scene: chooses the group and lets each part add its items.
#include "viz/scene/build_scene.h"

#include <algorithm>

#include "viz/scene/build_parts.h"
#include "viz/scene/near_part.h"

namespace covaria {
namespace {

/// The group of that name, of the result, else of the layout; without a name the first one.
Name shown_group(const SceneSource& source, const std::string& wanted) {
    const auto is_it = [&](const Name& group) {
        return !group.empty() && (wanted.empty() || group == wanted);
    };
    if (source.result)
        for (const OutputResult& output : source.result->outputs)
            if (is_it(output.quantity.group)) return output.quantity.group;
    if (source.layout) {
        for (const LayoutFrame& frame : source.layout->frames)
            if (is_it(frame.group)) return frame.group;
        for (const LayoutPoint& point : source.layout->points)
            if (is_it(point.group)) return point.group;
    }
    return wanted;
}

bool in_inches(const DisplayUnits& units) {
    const std::string chosen = units.of(Unit::of("mm")).text();
    return chosen == "in" || chosen == "ft" || chosen == "thou";
}

}  // namespace

std::string detail::SceneBuild::unique_id(const std::string& kind, const std::string& name) {
    const std::string wanted = kind + ":" + name;
    std::string id = wanted;
    for (int i = 2; !ids.insert(id).second; ++i) id = wanted + "#" + std::to_string(i);
    return id;
}

Scene build_scene(const SceneSource& whole, const SceneOptions& options) {
    SceneSource source = whole;
    const auto part = whole.layout ? detail::near_part(*whole.layout) : std::nullopt;
    if (part) source.layout = &part->layout;
    Scene scene;
    scene.title = source.title;
    scene.probability = options.probability;
    scene.numbers = options.language.numbers();
    scene.in_inches = in_inches(options.units);
    scene.group = shown_group(source, options.group);
    scene.group_title = options.language.say(said_name(scene.group));
    if (!source.layout) return scene;
    for (const Message& note : source.layout->notes) scene.notes.push_back(options.language.say(note));
    if (part) scene.notes.push_back(options.language.say(detail::words_of_left_out(part->left_out)));
    const PointUncertainties uncertainties(source.result, source.linked);
    const PointUncertainties before(source.compared ? source.compared->before.get() : nullptr);
    detail::SceneBuild build{source, options, uncertainties, before, scene};
    detail::add_items(build);
    detail::add_uncertainties(build);
    detail::add_floor(scene);
    detail::add_verdicts(build);
    if (source.map) {
        scene.map = *source.map;
        scene.map->ticks = detail::colour_ticks(*scene.map, scene.numbers);
    }
    detail::add_wall_histograms(build);
    if (options.labels) detail::add_labels(build);
    detail::add_axes(scene);
    detail::add_legend(build);
    return scene;
}

}  // namespace covaria
