// Axes, unit of length and labels of a scene.
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

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

constexpr std::size_t most_of_points = 10;  // named without being asked for: those with the largest U
constexpr int priority_not_met = 900;

struct Labels {
    Scene& scene;
    const DocumentLanguage& language;

    SceneLabel& add(const SceneItem& item, double clearance, int priority, Role role = Role::text) {
        const Text words = running_text(language.say(said_name(item.name)));
        return scene.labels.emplace_back(
            SceneLabel{words, item.position, clearance, role, priority, item.id});
    }
};

/// "U: 36, 51, 34 µm", with as many decimals as the largest needs to have two digits.
std::string fact_of(const SceneItem& item, const Scene& scene) {
    if (!item.U || !item.U->allFinite() || !(item.U->maxCoeff() > 0)) return {};
    constexpr double inch = 0.0254;
    const double largest = item.U->maxCoeff();
    const LengthUnit unit = scene.in_inches    ? LengthUnit{"thou", 1e3 / inch}
                            : largest < 1e-6   ? LengthUnit{"nm", 1e9}
                            : largest < 0.1e-3 ? LengthUnit{"µm", 1e6}
                            : largest < 1.0    ? LengthUnit{"mm", 1e3}
                                               : LengthUnit{"m", 1.0};
    const int decimals = std::max(0, decimals_for(unit.per_metre * largest));
    const char* between = scene.numbers.decimal == "," ? "; " : ", ";
    std::string words = "U: ";
    for (int i = 0; i < 3; ++i)
        words += (i ? between : "") + grouped_number(unit.per_metre * (*item.U)[i], decimals, scene.numbers);
    return words + "\u00a0" + unit.text;
}

/// The points whose uncertainty is largest, of outputs where there are any; without results the first ones.
std::set<std::string> named_points(const Scene& scene) {
    std::set<std::string> outputs;
    for (const SceneEllipsoid& ellipsoid : scene.ellipsoids)
        if (ellipsoid.role == Role::output) outputs.insert(ellipsoid.item.id);
    std::vector<const ScenePoint*> points;
    for (const ScenePoint& point : scene.points)
        if (!point.item.name.empty() && (outputs.empty() || outputs.contains(point.item.id)))
            points.push_back(&point);
    const auto largest = [](const ScenePoint* point) {
        return point->item.U && point->item.U->allFinite() ? point->item.U->maxCoeff() : 0.0;
    };
    std::ranges::stable_sort(points, std::greater(), largest);
    std::set<std::string> named;
    for (std::size_t i = 0; i < std::min(points.size(), most_of_points); ++i)
        named.insert(points[i]->item.id);
    return named;
}

void add_labels_of_points(const Scene& scene, Labels& labels) {
    const std::set<std::string> named = named_points(scene);
    std::set<std::string> not_met, instruments;
    for (const SceneVerdict& verdict : scene.not_met) not_met.insert(verdict.item);
    for (const SceneBody& body : scene.bodies)
        if (body.outline.empty()) instruments.insert(body.item.id);
    for (const ScenePoint& point : scene.points) {
        if (point.item.name.empty()) continue;
        const bool fails = not_met.contains(point.item.id);
        // An instrument is named on its own; its station's place is asked for.
        const bool is_station = point.kind == PointKind::station && instruments.contains(point.item.body);
        SceneLabel& label = labels.add(point.item, 1.2 * point.radius, fails ? priority_not_met : 50);
        label.fact = Text(fact_of(point.item, scene));
        label.when_asked = !fails && (is_station || !named.contains(point.item.id));
    }
}

}  // namespace

void add_labels(SceneBuild& build) {
    Scene& scene = build.scene;
    Labels labels{scene, build.options.language};
    add_labels_of_points(scene, labels);
    for (const SceneFrame& frame : scene.frames)
        if (!frame.item.name.empty()) labels.add(frame.item, 0.015 * scene.size, 40).when_asked = true;
    for (const SceneBody& body : scene.bodies)
        if (body.outline.empty() && !body.item.name.empty()) labels.add(body.item, 0.3 * body.size, 60);
    for (const SceneLink& link : scene.links) {
        if (link.item.name.empty()) continue;
        SceneItem place = link.item;
        if (link.kind == LinkKind::joint_axis) place.position = (link.from + link.to) / 2;
        labels.add(place, link.radius, 20, Role::quiet_text).when_asked = true;
    }
    for (const SceneVector& vector : scene.vectors) {
        SceneItem tip = vector.item;
        tip.name = vector.label;
        tip.position += vector.arrow;
        if (!tip.name.empty()) labels.add(tip, vector.radius, 45);
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
