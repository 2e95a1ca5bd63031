// Ellipsoids and clouds of the points of a scene, magnified about the estimates.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/text/numbers.h"
#include "core/text/round_numbers.h"
#include "viz/scene/build_parts.h"
#include "viz/scene/near_part.h"

namespace covaria::detail {
namespace {

// The automatic magnification:
// The mean of the two longest semi-axes of the largest ellipsoid is this part of the scene's size: it takes
// about a twentieth of a picture of the whole.
constexpr double largest_mean_axis = 0.105;
constexpr double same_place = 0.01;        // part of the scene's size: such points cannot be told apart
constexpr double room_to_neighbour = 0.7;  // part of the distance
constexpr double most_reduction = 6.0;     // below which ellipsoids would hardly be seen
constexpr double beyond_ball = 1.2;        // multiple of its radius: an ellipsoid is seen around a point

/// The points with an ellipsoid, with the item that `add_points` made for each.
struct UncertainPoint {
    const LayoutPoint* point;
    const SceneItem* drawn;
    Role role;
    double radius;  ///< radius of the ball that is drawn there, m
    CoverageEllipsoid ellipsoid;
    CoverageEllipsoid before = {};  ///< has rank 0 where nothing is compared

    double longest() const { return std::max(ellipsoid.axes.col(0).norm(), before.axes.col(0).norm()); }
    /// Mean radius seen from the side where it is largest; half of a line, which has no second axis.
    double mean_axis() const {
        const auto of = [](const CoverageEllipsoid& each) {
            const double first = each.axes.col(0).norm();
            return std::max(0.5 * first, std::sqrt(first * each.axes.col(1).norm()));
        };
        return std::max(of(ellipsoid), of(before));
    }
};

CoverageEllipsoid ellipsoid_of(const PointUncertainty& uncertainty, const LayoutPoint& point,
                               double probability) {
    return coverage_ellipsoid(point.R_WQ * uncertainty.covariance * point.R_WQ.transpose(), probability);
}

void add_uncertain(const SceneBuild& build, const LayoutPoint& point, const SceneItem& drawn, double radius,
                   std::vector<UncertainPoint>& found) {
    const auto uncertainty = build.uncertainties.of(point);
    if (!uncertainty) return;
    const double probability = build.options.probability;
    UncertainPoint made{&point, &drawn, uncertainty->of_outputs ? Role::output : Role::input, radius,
                        ellipsoid_of(*uncertainty, point, probability)};
    if (build.source.compared)
        if (const auto earlier = build.before.of(point_before(point, *build.source.compared)))
            made.before = ellipsoid_of(*earlier, point, probability);
    if (made.ellipsoid.rank > 0 || made.before.rank > 0) found.push_back(made);
}

std::vector<UncertainPoint> uncertain_points(const SceneBuild& build) {
    std::vector<UncertainPoint> found;
    std::size_t next = 0;
    for (const LayoutPoint& point : build.source.layout->points) {
        if (!build.shows(point.group) || next >= build.scene.points.size()) continue;
        const ScenePoint& drawn = build.scene.points[next++];
        add_uncertain(build, point, drawn.item, drawn.radius, found);
    }
    for (const VectorTip& tip : build.tips) add_uncertain(build, tip.point, tip.item, 0.0, found);
    return found;
}

/// A round ratio: near enough to the one wanted, and short to write.
double nearest_magnification(double wanted) {
    constexpr std::array steps{1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
    const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
    return decade * *std::ranges::min_element(
                        steps, {}, [&](double step) { return std::abs(std::log(step * decade / wanted)); });
}

/// Magnification at which no ellipsoid reaches much beyond half of the way to its neighbour of the same sort.
double magnification_with_room(const std::vector<UncertainPoint>& points, double size) {
    double least = std::numeric_limits<double>::infinity();
    for (const UncertainPoint& p : points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const UncertainPoint& other : points) {
            if (other.role != p.role) continue;
            const double distance = (other.drawn->position - p.drawn->position).norm();
            if (distance > same_place * size) nearest = std::min(nearest, distance);
        }
        least = std::min(least, room_to_neighbour * nearest / p.longest());
    }
    return least;
}

double automatic_magnification(const std::vector<UncertainPoint>& points, double size) {
    // Outputs are what a picture is about; inputs where there are none.
    double largest = 0.0;
    bool of_outputs = false;
    for (const UncertainPoint& p : points) {
        const bool first = p.role == Role::output && !of_outputs;
        if (p.role == Role::output) of_outputs = true;
        if (first || (p.role == Role::output) == of_outputs)
            largest = first ? p.mean_axis() : std::max(largest, p.mean_axis());
    }
    double wanted = largest > 0 ? largest_mean_axis * size / largest : 1.0;
    wanted = std::max(wanted / most_reduction, std::min(wanted, magnification_with_room(points, size)));
    if (!std::isfinite(wanted) || !(wanted > 0)) return 1.0;
    // Room or not, where all would be inside the balls of their points, there would be none to see.
    double first_seen = std::numeric_limits<double>::infinity();
    for (const UncertainPoint& p : points)
        first_seen = std::min(first_seen, beyond_ball * p.radius / p.longest());
    const bool limits = std::isfinite(first_seen) && first_seen > 0;
    return std::max(nearest_magnification(wanted), limits ? round_number_above(first_seen) : 0.0);
}

/// A box around the places of the outputs, with air, where they are a small part of the whole.
std::optional<SceneBounds> focus_of(const std::vector<UncertainPoint>& points, double size) {
    constexpr double small = 0.2, margin = 0.3;
    constexpr std::size_t fewest = 3;
    Eigen::AlignedBox3d box;
    std::size_t count = 0;
    for (const UncertainPoint& p : points) {
        if (p.role != Role::output) continue;
        box.extend(p.drawn->position);
        ++count;
    }
    if (count < fewest) return std::nullopt;
    const double extent = box.diagonal().norm();
    if (!(extent > same_place * size && extent < small * size)) return std::nullopt;
    const Eigen::Vector3d around = Eigen::Vector3d::Constant(margin * extent);
    return SceneBounds{box.min() - around, box.max() + around};
}

/// Rows of the trials matrix that belong to the point; null where there are none.
const Eigen::MatrixXd* trials_of(const SceneBuild& build, const UncertainPoint& p,
                                 std::array<std::size_t, 3>& rows) {
    const bool outputs = p.role == Role::output;
    const Eigen::MatrixXd* trials = outputs ? build.source.output_trials : build.source.input_trials;
    if (!trials || trials->cols() == 0) return nullptr;
    rows = outputs ? *p.point->outputs : *p.point->inputs;
    const auto count = static_cast<std::size_t>(trials->rows());
    return std::all_of(rows.begin(), rows.end(), [&](std::size_t r) { return r < count; }) ? trials : nullptr;
}

void add_cloud(SceneBuild& build, const UncertainPoint& p) {
    std::array<std::size_t, 3> rows{};
    const auto estimates = build.uncertainties.estimates_of(*p.point);
    if (!estimates) return;  // points of other analyses have their own trials
    const Eigen::MatrixXd* trials = trials_of(build, p, rows);
    if (!trials) return;
    const auto available = static_cast<std::size_t>(trials->cols());
    const std::size_t wanted = std::min(available, build.options.cloud_limit);
    SceneCloud cloud{*p.drawn, p.role, {}, {}};
    cloud.offsets.reserve(3 * wanted);
    for (std::size_t i = 0; i < wanted; ++i) {
        const auto t = static_cast<Eigen::Index>(i * available / wanted);
        Eigen::Vector3d d;
        for (int k = 0; k < 3; ++k)
            d[k] =
                (*trials)(static_cast<Eigen::Index>(rows[static_cast<std::size_t>(k)]), t) - (*estimates)[k];
        if (!d.allFinite()) continue;
        const Eigen::Vector3d offset = build.scene.magnification * (p.point->R_WQ * d);
        if (!is_near(offset)) continue;
        for (int k = 0; k < 3; ++k) cloud.offsets.push_back(static_cast<float>(offset[k]));
        cloud.trials.push_back(static_cast<std::uint32_t>(t));
    }
    if (cloud.size() > 0) build.scene.clouds.push_back(std::move(cloud));
}

std::optional<double> stated_magnification(const SceneOptions& options) {
    const double stated = options.magnification.value_or(0.0);
    return stated > 0 && std::isfinite(stated) ? options.magnification : std::nullopt;
}

/// "× 4 000"; what is drawn smaller than it is has a scale: "1 : 5 000 000". Never a row of zeros.
std::string magnification_words(const Scene& scene) {
    constexpr double most_zeros = 1e7;
    const double m = scene.magnification, smaller = 1.0 / m;
    const auto number = [&](double value) {
        return typeset_number(value < most_zeros ? round_number_text(value) : format_short(value, 4),
                              scene.numbers);
    };
    if (m >= 0.1) return "×\u00a0" + number(m);
    const bool is_whole = std::abs(smaller - std::round(smaller)) < 1e-6 * smaller;
    return "1\u00a0:\u00a0" + number(is_whole ? std::round(smaller) : smaller);
}

std::string caption_of(const Scene& scene, const SceneOptions& options) {
    if (!draws_uncertainty(scene)) return {};
    const bool ellipsoids = !scene.ellipsoids.empty() || !scene.ellipsoids_before.empty();
    return ellipsoids ? magnified_ellipsoids_words(scene, options)
                      : options.language.say(tell<"uncertainty %1">(magnification_words(scene)));
}

}  // namespace

double magnification_of(const SceneOptions& options, double automatic) {
    return stated_magnification(options).value_or(options.held_magnification.value_or(automatic));
}

std::string magnified_ellipsoids_words(const Scene& scene, const SceneOptions& options) {
    return options.language.say(tell<"ellipsoids %1, %2">(percent_text(options.probability, scene.numbers),
                                                          magnification_words(scene)));
}

void note_what_is_drawn(Scene& scene, std::size_t drawn, std::size_t all, const DocumentLanguage& in) {
    if (drawn < all) scene.notes.push_back(in.say(tell<"uncertainty drawn at %1 of %2 points">(drawn, all)));
}

void add_uncertainties(SceneBuild& build) {
    const auto points = uncertain_points(build);
    Scene& scene = build.scene;
    scene.focus = focus_of(points, scene.size);
    constexpr double largest_ball = 0.02;  // part of the size of what is looked at
    const double looked_at = scene.focus ? (scene.focus->high - scene.focus->low).norm() : scene.size;
    scene.magnification = magnification_of(build.options, automatic_magnification(points, looked_at));
    const auto draw = [&](const UncertainPoint& p, Role role, const CoverageEllipsoid& ellipsoid,
                          std::vector<SceneEllipsoid>& into) {
        const Eigen::Matrix3d axes = scene.magnification * ellipsoid.axes;
        if (build.options.ellipsoids && ellipsoid.rank > 0 && is_near(axes.rowwise().norm()))
            into.push_back({*p.drawn, role, axes, ellipsoid.rank, ellipsoid.coverage_factor});
    };
    for (const UncertainPoint& p : points) {
        draw(p, p.role, p.ellipsoid, scene.ellipsoids);
        draw(p, Role::before, p.before, scene.ellipsoids_before);
        if (build.options.clouds) add_cloud(build, p);
    }
    for (ScenePoint& point : scene.points) point.radius = std::min(point.radius, largest_ball * looked_at);
    scene.caption = caption_of(scene, build.options);
    if (!scene.caption.empty())
        note_what_is_drawn(scene, points.size(), build.source.layout->uncertain_points,
                           build.options.language);
}

}  // namespace covaria::detail
