// Input quantities of "pose from points": coordinates in frame 0 and the components they share; warnings.
#include <cmath>
#include <cstdio>
#include <map>

#include "core/models/pose_equations.h"

namespace covaria::pose {

namespace {

constexpr char axis_letters[] = "xyz";

class InputBuilder {
public:
    explicit InputBuilder(const PoseSetup& setup) : setup_(setup) {}

    InputSet build() {
        add_points(setup_.base, setup_.base_uncertainty, setup_.base_points, Side::base, 0);
        for (std::size_t k = 0; k < setup_.poses.size(); ++k)
            add_points(setup_.moving, setup_.moving_uncertainty, setup_.poses[k].points, Side::moving, k + 1);
        return std::move(inputs_);
    }

private:
    /// `pose` counts from 1; 0 is the base.
    void add_points(const FrameRule& rule, const UncertaintyRule& uncertainty,
                    const std::vector<Eigen::Vector3d>& points, Side side, std::size_t pose) {
        const Eigen::Matrix3d axes = frame_of(rule, points).linear();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::string letter = letter_of(side) + "_" + std::to_string(i + 1);
            const std::string suffix = pose == 0 ? "" : "_" + std::to_string(pose);
            std::array<std::vector<Share>, 3> shares;
            for (PointDeviation& d : deviations_at(rule.points[i], uncertainty, points[i])) {
                const bool turned = !is_world(uncertainty);
                const Eigen::Vector3d direction = turned ? Eigen::Vector3d(axes * d.direction) : d.direction;
                const std::size_t component = component_of(d, uncertainty, side, letter + suffix);
                for (int c = 0; c < 3;
                     ++c)  // what rounding leaves off the axes of a turned frame is no share
                    if (std::abs(direction[c]) > 1e-14 * direction.norm())
                        shares[static_cast<std::size_t>(c)].push_back({component, direction[c]});
            }
            const std::string path = source_path(side, i, pose);
            for (std::size_t c = 0; c < 3; ++c) {
                InputQuantity quantity;
                quantity.symbol = letter + axis_letters[c] + suffix;
                quantity.name = rule.points[i].name +
                                (pose == 0 ? "" : " in " + setup_.poses[pose - 1].name) + ", coordinate " +
                                axis_letters[c];
                quantity.unit = Unit::of("mm");
                quantity.offset = points[i][static_cast<int>(c)];
                quantity.shares = shares[c];
                quantity.group = pose == 0 ? "base" : setup_.poses[pose - 1].name;
                quantity.source = path;
                inputs_.quantities.push_back(std::move(quantity));
            }
        }
    }

    std::string source_path(Side side, std::size_t i, std::size_t pose) const {
        if (setup_.a_posteriori) return "/measured_points";
        if (pose > 0) return "/poses/rows/" + std::to_string(pose - 1);
        return "/" + prefix_of(side) + "_points/rows/" + std::to_string(i);
    }

    static bool is_world(const UncertaintyRule& rule) {
        return rule.asset && rule.asset->point_uncertainty()->axes() == PointUncertaintySource::Axes::world;
    }

    static std::vector<PointDeviation> deviations_at(const NominalPoint& point, const UncertaintyRule& rule,
                                                     const Eigen::Vector3d& p_0) {
        if (rule.asset)
            return rule.asset->point_uncertainty()->deviations(is_world(rule) ? p_0 : point.local);
        std::vector<PointDeviation> deviations;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::string axis(1, axis_letters[c]);
            const bool own = point.u[c].has_value();
            PointDeviation d{
                axis, "coordinate " + axis, Eigen::Vector3d::Unit(static_cast<int>(c)), {}, false};
            d.component = {.id = axis,
                           .name = d.name,
                           .unit = Unit::of("mm"),
                           .distribution = Distribution::normal(point.u[c].value_or(rule.u[c])),
                           .origin = "typed"};
            d.common = rule.common[c] && !own;
            deviations.push_back(std::move(d));
        }
        return deviations;
    }

    /// Index of the deviation's component: a new one, or the common one that another point has made.
    std::size_t component_of(PointDeviation& d, const UncertaintyRule& rule, Side side,
                             const std::string& point) {
        const std::string owner = rule.asset ? rule.asset_id : prefix_of(side);
        d.component.id = (d.common ? owner : point) + "." + d.id;
        if (rule.asset && !rule.asset_name.empty())
            d.component.origin = rule.asset_name + " (" + d.component.origin + ")";
        if (!d.common) return inputs_.add(std::move(d.component));
        const auto [known, is_new] = common_.try_emplace(d.component.id, inputs_.components.size());
        if (is_new) inputs_.add(std::move(d.component));
        return known->second;
    }

    const PoseSetup& setup_;
    InputSet inputs_;
    std::map<std::string, std::size_t> common_;
};

std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

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
        problems.warning("/" + prefix_of(side) + "_points",
                         "the standard uncertainty of a coordinate, " + rounded(1e3 * u) +
                             " mm, is more than a tenth of the distance of point " + rule.points[2].name +
                             " from the x-axis, " + rounded(1e3 * height) +
                             " mm: the law of propagation is not reliable here, look at Monte Carlo");
}

void warn_of_other_axes(const FrameRule& rule, Side side, Problems& problems) {
    std::vector<Eigen::Vector3d> local;
    for (const NominalPoint& p : rule.points) local.push_back(p.local);
    const Eigen::Isometry3d X = frame_of(rule, local);
    const double angle = Eigen::AngleAxisd(X.linear()).angle(), shift = X.translation().norm();
    const double size = (local[1] - local[0]).norm();
    if (angle < 1e-3 && shift < 1e-3 * size) return;
    problems.warning("/" + prefix_of(side) + "_points",
                     "the frame made from these points lies " + rounded(1e3 * shift) + " mm and " +
                         rounded(Unit::of("deg").from_si(angle)) +
                         "° away from the axes in which they are given, so results differ from the table of "
                         "poses; check the side of point 3 and the shift of the origin");
}

void warn_of_singular_orientation(const PoseSetup& setup, std::size_t k, Problems& problems) {
    constexpr double margin = 0.035;  // 2 degrees
    const Eigen::Isometry3d X_0b = frame_of(setup.base, setup.base_points);
    const Eigen::Isometry3d X_0p = frame_of(setup.moving, setup.poses[k].points);
    const Eigen::Matrix3d R = X_0b.linear().transpose() * X_0p.linear();
    if (regularity(setup.orientation, R) > margin) return;
    const std::string where = "/poses/rows/" + std::to_string(k), name = setup.poses[k].name;
    switch (setup.orientation) {
        case RotationConvention::zyx:
            problems.warning(where,
                             name +
                                 ": beta is within 2° of ±90°, where Z-Y-X angles are undefined (gimbal "
                                 "lock); state the orientation as a rotation vector");
            break;
        case RotationConvention::zyz:
            problems.warning(where, name +
                                        ": beta is within 2° of 0° or 180°, where Z-Y-Z angles are undefined "
                                        "(gimbal lock); state the orientation as Z-Y-X angles or a rotation "
                                        "vector");
            break;
        case RotationConvention::rotation_vector:
        case RotationConvention::quaternion:
            problems.warning(where, name +
                                        ": the rotation is within 4° of half a turn, where the sign of the "
                                        "axis is undefined; state the orientation as angles");
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
