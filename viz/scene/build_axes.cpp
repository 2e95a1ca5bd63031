// Axes, unit of length and labels of a scene.
#include <algorithm>
#include <cmath>

#include "core/base/name.h"
#include "core/text/head_with_unit.h"
#include "core/text/numbers.h"
#include "core/text/round_numbers.h"
#include "core/text/symbol.h"
#include "viz/scene/build_parts.h"

namespace covaria::detail {
namespace {

constexpr double air = 0.03;  // around everything, of the scene's size

LengthUnit unit_for(double size, bool in_inches) {
    constexpr double inch = 0.0254;
    if (in_inches && size < 0.1 * inch) return {"thou", 1e3 / inch};
    if (in_inches) return {"in", 1.0 / inch};
    if (size > 50.0) return {"m", 1.0};
    if (size < 1e-3) return {"µm", 1e6};
    return {"mm", 1e3};
}

constexpr std::size_t most_ticks = 64;  // on an axis of one tenth of the longest there are as many

std::vector<AxisTick> ticks_between(double low, double high, double wanted, const Scene& scene) {
    std::vector<AxisTick> ticks;
    const double per_metre = scene.unit.per_metre;
    // Far from the origin, places that are near to each other are the same number.
    const double told_apart = 4.0 * resolution_at(std::max(std::abs(low), std::abs(high)));
    const double step =
        wanted >= told_apart ? wanted : round_number_above(told_apart * per_metre) / per_metre;
    const int decimals = decimals_of_step(step * per_metre);
    for (const double at : multiples_between(low, high, step, most_ticks))
        ticks.push_back({at, grouped_number(at * per_metre, decimals, scene.numbers)});
    return ticks;
}

struct Labels {
    Scene& scene;
    const DocumentLanguage& language;

    void add(const SceneItem& item, double clearance, int priority, Role role = Role::text) {
        if (item.name.empty()) return;
        const Text words = running_text(language.say(said_name(item.name)));
        scene.labels.push_back({words, item.position, clearance, role, priority, item.id});
    }
};

/// Radius that the label of a point keeps clear: the point, and its ellipsoid where it is small.
double clearance_of(const ScenePoint& point) {
    return 1.2 * point.radius;
}

bool has_label(LinkKind kind) {
    return kind == LinkKind::dimension || kind == LinkKind::joint_axis;
}

}  // namespace

void add_labels(SceneBuild& build) {
    Scene& scene = build.scene;
    Labels labels{scene, build.options.language};
    for (const ScenePoint& point : scene.points) labels.add(point.item, clearance_of(point), 50);
    for (const SceneFrame& frame : scene.frames) labels.add(frame.item, 0.015 * scene.size, 40);
    const auto is_named_already = [&](const std::string& name) {  // an instrument at its station
        return std::any_of(scene.points.begin(), scene.points.end(),
                           [&](const ScenePoint& point) { return point.item.name == name; });
    };
    for (const SceneBody& body : scene.bodies)
        if (body.outline.empty() && !is_named_already(body.item.name))
            labels.add(body.item, 0.36 * body.size, 30);
    for (const SceneLink& link : scene.links) {
        if (!has_label(link.kind)) continue;
        SceneItem end = link.item;
        // The middle of a joint's axis is inside the arm, its z arrow before it; axes that meet part here.
        if (link.kind == LinkKind::joint_axis) end.position = link.from;
        labels.add(end, link.radius, 20, Role::quiet_text);
    }
    for (const SceneVector& vector : scene.vectors) {
        SceneItem tip = vector.item;
        tip.name = vector.label;
        tip.position += vector.arrow;
        labels.add(tip, vector.radius, 45);
    }
}

void add_axes(Scene& scene) {
    scene.axes.reset();
    if (!(scene.size > 0)) return;
    scene.unit = unit_for(scene.size, scene.in_inches);
    scene.scale_bar = true;
    const SceneBounds bounds = bounds_of(scene);
    SceneAxes axes;
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(air * scene.size);
    axes.low = bounds.low - margin;
    axes.high = bounds.high + margin;
    const Eigen::Vector3d extent = axes.high - axes.low;
    const auto round_step = [per_metre = scene.unit.per_metre](double length) {
        return nearest_round_number(length * per_metre) / per_metre;
    };
    const double step = round_step(extent.maxCoeff() / 6);
    // Between two numbers there is a scale: a step of half of the axis has two of them wherever it begins.
    const auto longest_step = [per_metre = scene.unit.per_metre](double length) {
        return round_number_below(length / 2 * per_metre) / per_metre;
    };
    static constexpr const char* names[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        axes.titles[k] = to_unicode(head_with_unit(names[i], scene.unit.text));
        const double own = extent[i] >= 2 * step ? step : round_step(extent[i] / 3);
        axes.ticks[k] =
            ticks_between(axes.low[i], axes.high[i], std::min(own, longest_step(extent[i])), scene);
    }
    scene.axes = std::move(axes);
}

std::vector<AxisTick> colour_ticks(const SceneMap& map, const NumberLocale& numbers) {
    std::vector<AxisTick> ticks;
    constexpr double parts = 4.0;  // at least
    const double told_apart = 4.0 * resolution_at(std::max(std::abs(map.low), std::abs(map.high)));
    if (!(map.high > map.low)) return ticks;
    const double wanted = round_number_below(map.high / parts - map.low / parts);
    const double step = wanted >= told_apart ? wanted : round_number_above(told_apart);
    const int decimals = decimals_of_step(step);
    for (const double at : multiples_between(map.low, map.high, step, most_ticks))
        ticks.push_back({at, grouped_number(at, decimals, numbers)});
    return ticks;
}

}  // namespace covaria::detail
