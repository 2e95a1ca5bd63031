// Positions, colours, iso-levels, best and worst point of a study.
#include "viz/scene/study_scene.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text/head_with_unit.h"
#include "core/text/numbers.h"
#include "core/text/round_numbers.h"
#include "viz/scene/build_parts.h"
#include "viz/scene/near_part.h"
#include "viz/scene/point_uncertainty.h"

namespace covaria {
namespace {

constexpr std::size_t no_triple = static_cast<std::size_t>(-1);
constexpr std::size_t most_ellipsoids = 2000;

/// The point in space that belongs to a quantity: its own, or that of one of its coordinates, or the first.
std::size_t triple_of(const StudyResult& study, const StudyQuantity& quantity) {
    if (quantity.position) return quantity.index;
    for (std::size_t t = 0; t < study.triples.size(); ++t) {
        const auto& outputs = study.triples[t].outputs;
        if (std::find(outputs.begin(), outputs.end(), quantity.index) != outputs.end()) return t;
    }
    return study.triples.empty() ? no_triple : 0;
}

SceneBounds bounds_of_points(const SceneMap& map) {
    SceneBounds box{Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()),
                    Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity())};
    for (std::size_t i = 0; i < map.positions.size(); ++i) {
        if (!std::isfinite(map.values[i])) continue;
        box.low = box.low.cwiseMin(map.positions[i]);
        box.high = box.high.cwiseMax(map.positions[i]);
    }
    return box;
}

/// Whether the three axes of the grid lead in three directions: else it has no volume for surfaces.
bool fills_volume(const StudyResult& study, const SceneMap& map) {
    if (study.axes.size() != 3) return false;
    const SceneBounds box = bounds_of_points(map);
    const Eigen::Vector3d middle = (box.low + box.high) / 2;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < map.positions.size(); ++i)
        if (std::isfinite(map.values[i]))
            spread += (map.positions[i] - middle) * (map.positions[i] - middle).transpose();
    const Eigen::Vector3d extents = Eigen::JacobiSVD<Eigen::Matrix3d>(spread).singularValues();
    return extents[2] > 1e-6 * extents[0];
}

SceneMap map_of(const StudyResult& study, const StudyQuantity& quantity, std::size_t triple,
                const StudySceneOptions& wanted) {
    SceneMap map;
    map.title = to_unicode(head_with_unit(quantity.id, quantity.unit));
    map.low = std::numeric_limits<double>::infinity();
    map.high = -map.low;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        const StudyPoint& point = study.points[i];
        map.values.push_back(quantity.unit.interval_from_si(value_at(study, quantity, i)));
        map.positions.push_back(point.has_values() ? point.places[triple].p_W
                                                   : Eigen::Vector3d(Eigen::Vector3d::Zero()));
        const bool in_slice = !wanted.slice_axis || *wanted.slice_axis >= study.axes.size() ||
                              study.indices_of(i)[*wanted.slice_axis] == wanted.slice;
        map.shown.push_back(in_slice);
        if (!detail::is_near(map.positions.back())) {
            map.positions.back().setZero();
            map.values.back() = std::numeric_limits<double>::quiet_NaN();
        }
        if (!std::isfinite(map.values.back())) continue;
        map.low = std::min(map.low, map.values.back());
        map.high = std::max(map.high, map.values.back());
    }
    if (!(map.high > map.low)) map.high = map.low + std::max(1e-12, 1e-3 * std::abs(map.low));
    const SceneBounds box = bounds_of_points(map);
    const double across = (box.high - box.low).norm();
    const double per_side = std::cbrt(static_cast<double>(std::max<std::size_t>(8, map.values.size())));
    map.radius = (wanted.ellipsoids ? 0.5 : 1.0) * std::min(0.012, 0.14 / per_side) * across;
    if (wanted.surfaces && fills_volume(study, map)) {
        for (std::size_t axis = 0; axis < 3; ++axis) map.grid[axis] = study.axes[axis].values.size();
        for (const double part : {0.25, 0.5, 0.75})
            map.levels.push_back(map.low + part * (map.high - map.low));
    }
    return map;
}

void add_extremes(const StudyResult& study, const StudyQuantity& quantity, const DocumentLanguage& in,
                  Scene& scene) {
    const StudyExtremes extremes = extremes_of(study, quantity);
    if (!extremes.known) return;
    const auto add = [&](const Message& words, std::size_t point) {
        const double value = scene.map->values[point];
        const int decimals =
            std::clamp(2 - static_cast<int>(std::floor(std::log10(std::max(value, 1e-300)))), 0, 9);
        const std::string said = in.say(words);
        scene.labels.push_back(
            {said + ": " + grouped_number(value, decimals, scene.numbers) + unit_after_number(quantity.unit),
             scene.map->positions[point], 1.4 * scene.map->radius, Role::text, 500});
        scene.points.push_back(
            {{.id = "map:" + words.english(), .name = said, .position = scene.map->positions[point]},
             PointKind::other,
             1.25 * scene.map->radius});
    };
    add(tell<"best">(), extremes.best);
    if (extremes.worst != extremes.best) add(tell<"worst">(), extremes.worst);
}

double automatic_magnification(const std::vector<CoverageEllipsoid>& ellipsoids, double room) {
    double largest = 0.0;
    for (const CoverageEllipsoid& ellipsoid : ellipsoids)
        largest = std::max(largest, ellipsoid.axes.col(0).norm());
    const double wanted = largest > 0 ? room / largest : 1.0;
    return std::isfinite(wanted) && wanted > 0 ? nearest_round_number(wanted) : 1.0;
}

/// Adds ellipsoids of the points drawn, so large that neighbours do not touch.
void add_ellipsoids(const StudyResult& study, std::size_t triple, const SceneOptions& options, Scene& scene) {
    std::vector<std::size_t> drawn;
    std::vector<CoverageEllipsoid> ellipsoids;
    std::size_t all = 0;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        if (!study.points[i].has_values() || !scene.map->shown[i]) continue;
        if (++all > most_ellipsoids) continue;
        const StudyPlace& place = study.points[i].places[triple];
        ellipsoids.push_back(
            coverage_ellipsoid(place.R_WQ * place.covariance * place.R_WQ.transpose(), options.probability));
        drawn.push_back(i);
    }
    scene.magnification =
        detail::magnification_of(options, automatic_magnification(ellipsoids, 5.0 * scene.map->radius));
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        const Eigen::Matrix3d axes = scene.magnification * ellipsoids[k].axes;
        if (ellipsoids[k].rank == 0 || !detail::is_near(axes.rowwise().norm())) continue;
        SceneItem item;
        item.id = "map:" + std::to_string(drawn[k]);
        item.name = study.triples[triple].name;
        item.position = scene.map->positions[drawn[k]];
        scene.ellipsoids.push_back(
            {item, Role::output, axes, ellipsoids[k].rank, ellipsoids[k].coverage_factor});
    }
    const DocumentLanguage& in = options.language;
    scene.legend.push_back({LegendMark::ellipsoid, Role::output, in.say(tell<"out">())});
    scene.caption = detail::magnified_ellipsoids_words(scene, options);
    detail::note_what_is_drawn(scene, drawn.size(), all, in);
}

std::string surface_words(const Scene& scene, const Unit& unit, const DocumentLanguage& in) {
    const SceneMap& map = *scene.map;
    const char* between = scene.numbers.decimal == "," ? "; " : ", ";
    std::string levels;
    const int decimals =
        std::clamp(2 - static_cast<int>(std::floor(std::log10(std::max(map.high, 1e-300)))), 0, 9);
    for (std::size_t i = 0; i < map.levels.size(); ++i)
        levels += (i ? between : "") + grouped_number(map.levels[i], decimals, scene.numbers);
    return in.say(tell<"iso-surfaces at %1">(levels + unit_after_number(unit)));
}

}  // namespace

Scene study_scene(const PreparedAnalysis& analysis, const StudyResult& study, const StudySceneOptions& wanted,
                  const SceneOptions& options) {
    std::vector<double> x;
    for (std::size_t i = 0; i < analysis.inputs.quantities.size(); ++i)
        x.push_back(estimate_of(analysis.inputs, i));
    const Layout layout = analysis.model->layout(x);
    SceneSource source{&layout, nullptr, nullptr, nullptr, study.name};
    const auto quantities = study_quantities(study);
    const auto plain = [&](const Message& caption) {
        Scene scene = build_scene(source, options);
        scene.caption = options.language.say(caption);
        return scene;
    };
    if (quantities.empty()) return plain(tell<"the study has not been run">());
    const StudyQuantity& quantity = quantities[std::min(wanted.quantity, quantities.size() - 1)];
    const std::size_t triple = triple_of(study, quantity);
    if (triple == no_triple)
        return plain(tell<"none of the study's output quantities has a place in space">());
    const SceneMap map = map_of(study, quantity, triple, wanted);
    if (!(map.radius > 0) || !std::isfinite(map.radius))
        return plain(tell<"the point %1 does not move in this study">(study.triples[triple].name));
    source.map = &map;
    Scene scene = build_scene(source, options);
    if (wanted.ellipsoids) add_ellipsoids(study, triple, options, scene);
    add_extremes(study, quantity, options.language, scene);
    if (!map.levels.empty())
        scene.legend.push_back(
            {LegendMark::none, Role::quiet_text, surface_words(scene, quantity.unit, options.language)});
    return scene;
}

}  // namespace covaria
