// Results of the joint trajectories: parameters with their covariance, tables, layout.
#include <cmath>
#include <numbers>

#include "core/base/name.h"
#include "core/kinds/robot/layout.h"
#include "core/kinds/robot_identification/from_trajectories.h"
#include "core/quantity/input_quantity.h"

namespace covaria::circle_points {

namespace {

struct Estimates {
    explicit Estimates(const InputSet& inputs) {
        for (std::size_t i = 0; i < inputs.quantities.size(); ++i) x.push_back(estimate_of(inputs, i));
    }
    double operator[](std::size_t i) const { return x[i]; }
    std::vector<double> x;
};

Table circles_table(const Identification& id) {
    const Unit mm = Unit::of("mm");
    Table table{"circles", "Circles of the joints"};
    table.add("joint");
    table.add("points");
    table.add("arc").in(Unit::of("deg")).figure(4);
    table.add("radius").in(mm).figure(6);
    table.add("rms along the radius").in(mm).figure(2);
    table.add("rms off the plane").in(mm).figure(2);
    for (std::size_t j = 0; j < id.trajectories.size(); ++j) {
        const Trajectory& t = id.trajectories[j];
        double along = 0.0, off = 0.0;
        for (const Eigen::Vector3d& p : t.points) {
            const Eigen::Vector3d q = t.shape.start.axes.transpose() * (p - t.shape.start.centre);
            along += std::pow(q.head<2>().norm() - t.shape.start.radius, 2);
            off += q.z() * q.z();
        }
        const auto n = static_cast<double>(t.points.size());
        table.row({static_cast<double>(j + 1), n, t.shape.arc, t.shape.start.radius, std::sqrt(along / n),
                   std::sqrt(off / n)});
    }
    if (id.simulated)
        table.notes.push_back(tell<"Simulated points of the nominal robot: they lie on their circles.">());
    return table;
}

}  // namespace

std::optional<std::vector<double>> estimates(const Identification& id) {
    const Estimates x(id.inputs);
    std::vector<double> y(id.parameters.size() + id.trajectories.size());
    if (!evaluate<double>(id, x, [&](std::size_t j, double value) { y[j] = value; })) return {};
    y.resize(id.parameters.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        if (!std::isfinite(y[i])) return {};
        const IdentifiedParameter& p = id.parameters[i];
        y[i] = next_to(id.robot().joints()[p.joint].values[p.parameter], p.parameter, y[i]);
    }
    return y;
}

std::vector<Table> tables(const Identification& id) {
    return {circles_table(id),
            identified_table(id.robot(), id.parameters, estimates(id).value_or(std::vector<double>{})),
            held_table(id.missing)};
}

namespace {

void add_circle(const Trajectory& t, const Name& name, double axis, Layout& layout) {
    const CircleStart& s = t.shape.start;
    LayoutBody disc{.name = own_name<"circle of %1">(said_name(name))};
    constexpr int corners = 72;
    for (int k = 0; k < corners; ++k) {
        const double a = 2.0 * std::numbers::pi * k / corners;
        disc.outline_W.push_back(s.centre +
                                 s.radius * (std::cos(a) * s.axes.col(0) + std::sin(a) * s.axes.col(1)));
    }
    layout.bodies.push_back(std::move(disc));
    layout.links.push_back({.name = own_name<"axis of %1">(said_name(name)),
                            .kind = LinkKind::joint_axis,
                            .from_W = s.centre - axis * s.axes.col(2),
                            .to_W = s.centre + axis * s.axes.col(2)});
}

/// The last point of an arc shows its uncertainty; those of all points together would hide the circles.
void add_points(const Trajectory& t, const Name& name, Layout& layout) {
    const std::size_t n = t.points.size();
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = t.first_input + 3 * k;
        LayoutPoint point{.name = k + 1 == n ? name : Name(), .kind = PointKind::target, .p_W = t.points[k]};
        if (!t.rows.empty()) point.source.path = fields().place(&Identification::points, t.rows[k]);
        if (k + 1 == n) point.inputs = {{i, i + 1, i + 2}};
        layout.points.push_back(std::move(point));
    }
    layout.uncertain_points += n;
}

/// The identified arm, at its zero readings, where its axes were found.
void add_identified_arm(const Identification& id, Layout& layout) {
    const auto values = estimates(id);
    if (!values) return;
    std::array<AxisLine<double>, most_joints> axes;
    std::array<AxisFrame<double>, most_joints> frames;
    const std::size_t n = id.trajectories.size();
    for (std::size_t j = 0; j < n; ++j) {
        const CircleStart& s = id.trajectories[j].shape.start;
        axes[j] = {s.centre, s.axes.col(2)};
    }
    frames_from_axes(axes.data(), n, id.structure, frames.data());
    RobotData data = identified_robot(id.robot(), id.parameters, *values);
    data.X_WB.linear() << frames[0].x, frames[0].y, frames[0].z;
    data.X_WB.translation() = frames[0].o;
    const RobotSource robot(std::move(data));
    std::vector<double> zero;
    for (const RobotJoint& joint : robot.joints()) zero.push_back(joint.zero);
    add_arm(robot, zero, "", layout);
    std::erase_if(layout.links, [](const LayoutLink& link) {  // the circles have drawn theirs
        return link.kind == LinkKind::joint_axis && !link.name.starts_with("axis of");
    });
}

}  // namespace

Layout layout(const Identification& id) {
    Layout layout;
    double size = 0.0;
    for (const Trajectory& t : id.trajectories) size = std::max(size, t.shape.start.radius);
    for (std::size_t j = 0; j < id.trajectories.size(); ++j) {
        const Name name = own_name<"joint %1">(j + 1);
        add_circle(id.trajectories[j], name, 0.2 * size, layout);
        add_points(id.trajectories[j], name, layout);
    }
    add_identified_arm(id, layout);
    return layout;
}

std::optional<RobotData> identified(const Identification& id) {
    const auto values = estimates(id);
    if (!values) return {};
    RobotData data = identified_robot(id.robot(), id.parameters, *values);
    for (std::size_t j = 0; j + 1 < data.joints.size(); ++j) {
        data.joints[j].parallel = id.structure.parallel[j];
        if (data.joints[j].parallel) data.joints[j].values.d = 0.0;
    }
    return data;
}

}  // namespace covaria::circle_points
