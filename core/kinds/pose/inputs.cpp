// Input quantities of "pose from points": coordinates in frame 0 and the components they share; warnings.
#include <cmath>
#include <map>
#include <set>

#include "core/base/name.h"
#include "core/kinds/points/point_uncertainty.h"
#include "core/kinds/points/stated_figure.h"
#include "core/kinds/pose/equations.h"
#include "core/quantity/input_quantity.h"
#include "core/text/numbers.h"

namespace covaria::pose {

namespace {

/// A point in frame 0, and how its deviations reach its coordinates.
struct MeasuredPoint {
    const FrameRule* rule;
    const UncertaintyRule* uncertainty;
    Side side;
    std::size_t index;  ///< number of the point in its frame
    std::size_t pose;   ///< counts from 1; 0 is the base
    Eigen::Vector3d p_0;
    Eigen::Matrix3d axes;  ///< axes of its uncertainties: those of its own frame, or of the base

    const NominalPoint& nominal() const { return rule->points[index]; }
    std::string letter() const { return letter_of(side) + "_" + std::to_string(index + 1); }
    std::string suffix() const { return pose == 0 ? "" : "_" + std::to_string(pose); }
    std::string symbol() const { return letter() + suffix(); }
};

using Shares = std::array<std::vector<Share>, 3>;

/// Output of the analysis that measured the point; empty: an instrument or a typed figure did.
std::optional<OutputReference> output_of(const UncertaintyRule& rule, const std::string& point,
                                         std::size_t axis) {
    const auto* source = offers<PointOutputSource>(rule.source.asset);
    return source ? source->coordinate(point, axis) : std::nullopt;
}

/// A point of the moving frame is another one in each pose.
std::string name_among_all(const PoseSetup& setup, const NominalPoint& point, std::size_t pose) {
    return pose == 0 ? point.name : point.name + " in " + setup.poses[pose - 1].name;
}

class InputBuilder {
public:
    explicit InputBuilder(const PoseSetup& setup) : setup_(setup) {}

    InputSet build() {
        list_points(setup_.base, setup_.base_uncertainty, setup_.base_points, 0);
        for (std::size_t k = 0; k < setup_.poses.size(); ++k)
            list_points(setup_.moving, setup_.moving_uncertainty, setup_.poses[k].points, k + 1);
        shares_.resize(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (points_[i].uncertainty->source)
                add_source(points_[i].uncertainty->source);
            else
                add_typed(i);
            add_quantities(i);
        }
        return std::move(inputs_);
    }

private:
    void list_points(const FrameRule& rule, const UncertaintyRule& uncertainty,
                     const std::vector<Eigen::Vector3d>& points, std::size_t pose) {
        const bool along_base = uncertainty.along_base;
        const Eigen::Matrix3d axes =
            along_base ? frame_of(setup_.base, setup_.base_points).linear() : frame_of(rule, points).linear();
        const Side side = pose == 0 ? Side::base : Side::moving;
        for (std::size_t i = 0; i < points.size(); ++i)
            points_.push_back({&rule, &uncertainty, side, i, pose, points[i], axes});
    }

    void add_quantities(std::size_t i) {
        const MeasuredPoint& point = points_[i];
        for (std::size_t c = 0; c < 3; ++c) {
            InputQuantity quantity;
            quantity.symbol = point.letter() + along_axes[c] + point.suffix();
            const std::string& name = point.nominal().name;
            quantity.name = point.pose == 0 ? tell<"%1, coordinate %2">(name, along_axes[c])
                                            : tell<"%1 in %2, coordinate %3">(
                                                  name, setup_.poses[point.pose - 1].name, along_axes[c]);
            quantity.unit = Unit::of("mm");
            quantity.offset = point.p_0[static_cast<int>(c)];
            quantity.shares = shares_[i][c];
            quantity.group = point.pose == 0 ? own_name<"base">() : Name(setup_.poses[point.pose - 1].name);
            quantity.source = source_path(point);
            quantity.taken_from =
                output_of(*point.uncertainty, name_among_all(setup_, point.nominal(), point.pose), c);
            inputs_.quantities.push_back(std::move(quantity));
        }
    }

    std::string source_path(const MeasuredPoint& point) const {
        if (setup_.a_posteriori) return pose_fields().place(&PoseSetup::measured);
        if (point.pose > 0) return pose_fields().place(&PoseSetup::poses, point.pose - 1);
        return frame_fields(point.side).place(&FrameRule::points, point.index);
    }

    /// Adds all points that the source measures, together, when the first of them is reached.
    void add_source(const Offered<PointUncertaintySource>& source) {
        if (!added_.insert(source.source).second) return;
        std::vector<std::size_t> measured;
        std::vector<Eigen::Vector3d> places;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (points_[i].uncertainty->source.source != source.source) continue;
            measured.push_back(i);
            places.push_back(points_[i].uncertainty->is_world() ? points_[i].p_0
                                                                : points_[i].nominal().local);
        }
        for (JointDeviation& d : source->joint_deviations(places)) {
            const std::string owner = d.owner.empty() ? source.id : d.owner;
            const std::string whose = d.point ? points_[measured[*d.point]].symbol() : owner;
            const std::size_t before = inputs_.components.size();
            const std::size_t component = component_of(d.component, whose + "." + d.id, source, !d.point);
            if (!d.point) inputs_.components[component].identity = inputs_.components[component].id;
            if (!d.estimate.empty() && component == before)
                inputs_.rest_on_estimate(owner + "." + d.estimate, component, true);
            for (std::size_t k = 0; k < measured.size(); ++k) {
                const MeasuredPoint& point = points_[measured[k]];
                const Eigen::Vector3d& direction = d.directions[k];
                add_shares(
                    measured[k], component,
                    point.uncertainty->is_world() ? direction : Eigen::Vector3d(point.axes * direction));
            }
        }
    }

    void add_typed(std::size_t i) {
        const MeasuredPoint& point = points_[i];
        for (std::size_t c = 0; c < 3; ++c) {
            const std::string axis = along_axes[c];
            const std::optional<double>& own = point.nominal().u[c];
            const bool common = point.uncertainty->common[c] && !own;
            UncertaintyComponent component{
                .id = {},
                .name = tell<"coordinate %1">(axis),
                .unit = Unit::of("mm"),
                .distribution = distribution_of_shape(point.uncertainty->distribution,
                                                      own.value_or(point.uncertainty->u[c])),
                .origin = tell<"typed">()};
            const std::string id = (common ? prefix_of(point.side) : point.symbol()) + "." + axis;
            add_shares(i, component_of(component, id, {}, common), point.axes.col(static_cast<int>(c)));
        }
    }

    /// Adds the shares of a component along a direction; rounding off the axes of a turned frame is no share.
    void add_shares(std::size_t point, std::size_t component, const Eigen::Vector3d& direction) {
        for (int c = 0; c < 3; ++c)
            if (std::abs(direction[c]) > 1e-14 * direction.norm())
                shares_[point][static_cast<std::size_t>(c)].push_back({component, direction[c]});
    }

    /// Index of the component: a new one, or the common one that another point has made.
    std::size_t component_of(UncertaintyComponent& component, const std::string& id,
                             const Offered<PointUncertaintySource>& source, bool common) {
        component.id = id;
        if (source) component.origin = tell<"%1 (%2)">(source.name, component.origin);
        component.contributor = source.id;
        component.contributor_name = source.name;
        component.local = !common;
        if (!common) return inputs_.add(std::move(component));
        const auto [known, is_new] = common_.try_emplace(id, inputs_.components.size());
        if (is_new) inputs_.add(std::move(component));
        return known->second;
    }

    const PoseSetup& setup_;
    InputSet inputs_;
    std::vector<MeasuredPoint> points_;
    std::vector<Shares> shares_;
    std::set<const PointUncertaintySource*> added_;
    std::map<std::string, std::size_t> common_;
};

// Largest standard uncertainty of the frame's coordinates over the height of its triangle.
void warn_of_large_uncertainty(const PoseSetup& setup, const InputSet& inputs, Side side,
                               Problems& problems) {
    const bool of_base = side == Side::base;
    const FrameRule& rule = of_base ? setup.base : setup.moving;
    if (rule.least_squares) return;
    const Eigen::Vector3d d = rule.points[1].local - rule.points[0].local,
                          e = rule.points[2].local - rule.points[0].local;
    const double height = d.cross(e).norm() / d.norm();
    const std::size_t first = of_base ? 0 : 3 * setup.base.points.size();
    const std::size_t count = 3 * rule.points.size() * (of_base ? 1 : setup.poses.size());
    double u = 0.0;
    for (std::size_t i = first; i < first + count; ++i) u = std::max(u, standard_uncertainty_of(inputs, i));
    if (u > 0.1 * height)
        problems.warning(
            frame_fields(side).place(&FrameRule::points),
            tell<"the standard uncertainty of a coordinate, %1 mm, is more than a tenth of the distance of "
                 "point %2 from the x-axis, %3 mm: the law of propagation is not reliable here, look at "
                 "Monte Carlo">(Message::number(format_short(1e3 * u)), rule.points[2].name,
                                Message::number(format_short(1e3 * height))));
}

void warn_of_other_axes(const FrameRule& rule, Side side, Problems& problems) {
    std::vector<Eigen::Vector3d> local;
    for (const NominalPoint& p : rule.points) local.push_back(p.local);
    const Eigen::Isometry3d X = frame_of(rule, local);
    const double angle = Eigen::AngleAxisd(X.linear()).angle(), shift = X.translation().norm();
    double size = 0.0;
    for (const Eigen::Vector3d& p : local) size = std::max(size, (p - local[0]).norm());
    if (angle < 1e-3 && shift < 1e-3 * size) return;
    problems.warning(
        frame_fields(side).place(&FrameRule::points),
        tell<"the frame made from these points lies %1 mm and %2° away from the axes in which they are "
             "given, so results differ from the table of poses; check the side of point 3 and the shift of "
             "the origin">(Message::number(format_short(1e3 * shift)),
                           Message::number(format_short(Unit::of("deg").from_si(angle)))));
}

void warn_of_singular_orientation(const PoseSetup& setup, std::size_t k, Problems& problems) {
    constexpr double margin = 0.035;  // 2 degrees
    const Eigen::Isometry3d X_0b = frame_of(setup.base, setup.base_points);
    const Eigen::Isometry3d X_0p = frame_of(setup.moving, setup.poses[k].points);
    const Eigen::Matrix3d R = X_0b.linear().transpose() * X_0p.linear();
    if (regularity(setup.orientation, R) > margin) return;
    const std::string where = pose_fields().place(&PoseSetup::poses, k), name = setup.poses[k].name;
    switch (setup.orientation) {
        case RotationConvention::zyx:
            problems.warning(where, tell<"%1: beta is within 2° of ±90°, where Z-Y-X angles are undefined "
                                         "(gimbal lock); state the orientation as a rotation vector">(name));
            break;
        case RotationConvention::zyz:
            problems.warning(
                where, tell<"%1: beta is within 2° of 0° or 180°, where Z-Y-Z angles are undefined (gimbal "
                            "lock); state the orientation as Z-Y-X angles or a rotation vector">(name));
            break;
        case RotationConvention::rotation_vector:
        case RotationConvention::quaternion:
            problems.warning(where, tell<"%1: the rotation is within 4° of half a turn, where the sign of "
                                         "the axis is undefined; state the orientation as angles">(name));
            break;
    }
}

}  // namespace

Eigen::Isometry3d frame_of(const FrameRule& rule, const std::vector<Eigen::Vector3d>& q) {
    std::vector<double> x;
    for (const Eigen::Vector3d& p : q) x.insert(x.end(), {p.x(), p.y(), p.z()});
    const Frame<double> f = frame<double>(rule, x.data(), 0);
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = f.R;
    X.translation() = f.o;
    return X;
}

void check_measurable(const PoseSetup& setup, Problems& problems) {
    const auto check = [&](const FrameRule& rule, const UncertaintyRule& uncertainty,
                           const std::vector<Eigen::Vector3d>& points, std::size_t pose,
                           const auto& place_of) {
        if (!uncertainty.source) return;
        const bool of_analysis = offers<PointOutputSource>(uncertainty.source.asset) != nullptr;
        for (std::size_t i = 0; of_analysis && i < points.size(); ++i)
            if (const std::string name = name_among_all(setup, rule.points[i], pose);
                !output_of(uncertainty, name, 0))
                problems.error(place_of(i), tell<"the analysis %1 has no point called '%2'">(
                                                uncertainty.source.name, name));
        const bool world = uncertainty.is_world();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Message objection = uncertainty.source->objection(world ? points[i] : rule.points[i].local);
            if (!objection.empty())
                problems.error(place_of(i), tell<"point %1 cannot be measured by %2: %3">(
                                                rule.points[i].name, uncertainty.source.name, objection));
        }
    };
    check(setup.base, setup.base_uncertainty, setup.base_points, 0,
          [](std::size_t i) { return frame_fields(Side::base).place(&FrameRule::points, i); });
    for (std::size_t k = 0; k < setup.poses.size(); ++k)
        check(setup.moving, setup.moving_uncertainty, setup.poses[k].points, k + 1,
              [k](std::size_t) { return pose_fields().place(&PoseSetup::poses, k); });
}

InputSet pose_inputs(const PoseSetup& setup) {
    return InputBuilder(setup).build();
}

void warn_about(const PoseSetup& setup, const InputSet& inputs, Problems& problems) {
    for (Side side : {Side::base, Side::moving}) {
        warn_of_large_uncertainty(setup, inputs, side, problems);
        if (!setup.a_posteriori)
            warn_of_other_axes(side == Side::base ? setup.base : setup.moving, side, problems);
    }
    for (std::size_t k = 0; k < setup.poses.size(); ++k) warn_of_singular_orientation(setup, k, problems);
}

}  // namespace covaria::pose
