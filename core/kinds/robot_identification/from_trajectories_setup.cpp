// Reads the points of the joint trajectories, checks them, decides on the structure of the arm.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot_identification/from_trajectories.h"
#include "core/math/decompositions.h"
#include "core/quantity/input_quantity.h"
#include "core/text/numbers.h"

namespace covaria::circle_points {

namespace {

Message joint_words(std::size_t j) {
    return tell<"joint %1">(j + 1);
}

Name joint_name(std::size_t j) {
    return Name::of(joint_words(j));
}

std::string millimetres(double m) {
    return format_short(1e3 * m) + " mm";
}

std::string degrees(double rad) {
    return format_short(rad * 180.0 / std::numbers::pi) + "°";
}

template <class... M>
std::string place(M... members) {
    return fields().place(members...);
}

/// Decision which axes are parallel, where their common perpendiculars run, and which parameters there are.
class Structure {
public:
    Structure(Identification& id, Problems& problems) : id_(id), problems_(problems) {}

    void decide() {
        const std::size_t n = id_.trajectories.size();
        const NominalFrames nominal = nominal_frames();
        const auto axis = [&](std::size_t j) -> Eigen::Vector3d {
            return id_.trajectories[j].shape.start.axes.col(2);
        };
        Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
        for (std::size_t j = 0; j < n; ++j) H += axis(j) * nominal.z[j].transpose();
        const Eigen::Matrix3d R = rotation_nearest(H);
        for (std::size_t j = 0; j < n; ++j)
            if (axis(j).dot(R * nominal.z[j]) < 0.0)
                problems_.error(
                    id_.simulated ? place(&Identification::nominal) : place(&Identification::points),
                    tell<"the points of %1 run against the positive direction of the joint: reverse their "
                         "order, or give its readings">(joint_words(j)));
        const double limit = std::sin(id_.parallel_limit);
        const RobotJoint& first = id_.robot().joints()[0];
        id_.structure.theta_1 = first.values.theta;
        id_.structure.d_1 = first.values.d;
        for (std::size_t j = 0; j + 1 < n; ++j) {
            const double sine = axis(j).cross(axis(j + 1)).norm();
            id_.structure.parallel.push_back(sine < limit);
            id_.structure.opposite.push_back(axis(j).dot(axis(j + 1)) < 0.0);
            warn_of_parallel(j, sine, sine < limit);
        }
        decide_sides(R, nominal);
    }

    void list_parameters() {
        const std::size_t n = id_.trajectories.size();
        for (std::size_t j = 0; j < n; ++j)
            for (JointParameter p : joint_parameters) {
                const IdentifiedParameter parameter{j, p};
                const Message reason = reason_against(j, p);
                const bool exists = p != JointParameter::beta || (j + 1 < n && id_.structure.parallel[j]);
                if (reason.empty() && exists) id_.parameters.push_back(parameter);
                if (!reason.empty() && exists) id_.missing.push_back({parameter.symbol(), reason});
            }
        id_.missing.push_back({tell<"tool">(), tell<"one ball is one point: it has no orientation">()});
    }

private:
    /// Directions of the nominal axes and x-axes, in the base frame.
    struct NominalFrames {
        std::vector<Eigen::Vector3d> z, x;
    };
    NominalFrames nominal_frames() const {
        std::vector<double> zero;
        for (const RobotJoint& joint : id_.robot().joints()) zero.push_back(joint.zero);
        NominalFrames found;
        for (const Eigen::Isometry3d& X : link_frames(id_.robot(), zero)) {
            found.z.push_back(X.linear().col(2));
            found.x.push_back(X.linear().col(0));
        }
        return found;
    }

    static Eigen::Matrix3d rotation_nearest(const Eigen::Matrix3d& H) {
        const auto svd = singular_values(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
        Eigen::Vector3d d = Eigen::Vector3d::Ones();
        d[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
        return svd.matrixU() * d.asDiagonal() * svd.matrixV().transpose();
    }

    void warn_of_parallel(std::size_t j, double sine, bool parallel) {
        if (parallel == id_.robot().joints()[j].parallel) return;
        const Message axes = tell<"the axes of joints %1 and %2">(j + 1, j + 2);
        if (parallel)
            problems_.warning(
                place(&Identification::nominal),
                tell<"%1 are nearly parallel (%2): they are described by beta with d = 0, because the place "
                     "of their common perpendicular is hardly determined">(axes, degrees(std::asin(sine))));
        else
            problems_.warning(place(&Identification::nominal),
                              tell<"%1 are %2 apart: they are described by d without beta, although the "
                                   "nominal robot has beta">(axes, degrees(std::asin(std::min(1.0, sine)))));
    }

    void decide_sides(const Eigen::Matrix3d& R, const NominalFrames& nominal) {
        const std::size_t n = id_.trajectories.size();
        id_.structure.side.assign(n - 1, 1.0);
        std::array<AxisLine<double>, most_joints> axes;
        std::array<AxisFrame<double>, most_joints> frames;
        for (std::size_t j = 0; j < n; ++j) {
            const CircleStart& start = id_.trajectories[j].shape.start;
            axes[j] = {start.centre, start.axes.col(2)};
        }
        frames_from_axes(axes.data(), n, id_.structure, frames.data());
        for (std::size_t j = 0; j + 1 < n; ++j) {
            const Eigen::Vector3d x = R * nominal.x[j + 1];
            if (frames[j + 1].x.dot(x) < 0.0) id_.structure.side[j] = -1.0;
            if (!frames[j + 1].x.allFinite())
                problems_.error(
                    place(&Identification::points),
                    tell<"the axes of joints %1 and %2 are the same line: nothing tells their frames apart">(
                        j + 1, j + 2));
        }
    }

    Message reason_against(std::size_t j, JointParameter p) const {
        const std::size_t n = id_.trajectories.size();
        const bool place = p == JointParameter::theta || p == JointParameter::d;
        if (j == 0 && place)
            return tell<
                "places the base frame on axis 1: by definition, as nominal; it would need a measured "
                "base">();
        if (j + 1 == n)
            return tell<
                "places the frame of the last link, which no axis follows: by definition, as nominal">();
        if (p == JointParameter::d && id_.structure.parallel[j]) return parallel_to_the_next();
        return {};
    }

    Identification& id_;
    Problems& problems_;
};

class Reading {
public:
    Reading(StatedIdentification stated, Problems& problems) : problems_(problems), id_(std::move(stated)) {}

    std::optional<Identification> read() {
        check_robot();
        if (problems_.has_errors()) return {};
        id_.trajectories.resize(id_.robot().joints().size());
        if (id_.simulated)
            simulate();
        else
            read_points();
        if (problems_.has_errors()) return {};
        add_inputs();
        for (std::size_t j = 0; j < id_.trajectories.size(); ++j) shape(j);
        if (problems_.has_errors()) return {};
        Structure structure(id_, problems_);
        structure.decide();
        if (problems_.has_errors()) return {};
        structure.list_parameters();
        id_.evidence = evidence_of(id_);
        if (!id_.simulated)
            take_as_seen(id_.inputs, id_.evidence, id_.uncertainties, place(&Identification::uncertainties),
                         problems_);
        return std::move(id_);
    }

private:
    void check_robot() {
        const std::string nominal = place(&Identification::nominal);
        if (id_.robot().convention() == DhConvention::craig)
            problems_.error(nominal, tell<"parameters are identified by Eq 5: describe the nominal robot in "
                                          "that convention, not in Craig's">());
        if (const std::size_t sliding = first_sliding_joint(id_.robot()); sliding > 0)
            problems_.error(nominal, tell<"joint %1 slides and draws no circle: take an arm without it, as "
                                          "it stands during the measurement">(sliding));
        if (id_.robot().joints().size() < 2)
            problems_.error(nominal, tell<"an arm of one joint has no parameters between two axes">());
        if (const std::size_t coupled = first_coupled_joint(id_.robot()))
            problems_.error(
                nominal,
                tell<"joint %1 is moved along by another, so that a joint that turns alone does "
                     "not lead a point round its axis: identify it from poses or readings">(coupled));
    }

    void simulate() {
        const SerialRobotSource& robot = id_.robot();
        const std::size_t count = id_.point_count;
        std::vector<double> zero;
        for (const RobotJoint& joint : robot.joints()) zero.push_back(joint.zero);
        for (std::size_t j = 0; j < robot.joints().size(); ++j)
            for (std::size_t k = 0; k < count; ++k) {
                std::vector<double> q = zero;
                const double share = static_cast<double>(k) / static_cast<double>(count - 1);
                q[j] += robot.joints()[j].direction * id_.half_range * (2.0 * share - 1.0);
                const std::vector<Eigen::Isometry3d> frames = link_frames(robot, q);
                id_.trajectories[j].points.push_back(robot.X_WB() * frames[q.size()] *
                                                     id_.ball.translation());
            }
    }

    void read_points() {
        readings_.resize(id_.trajectories.size());
        for (std::size_t row = 0; row < id_.points.size(); ++row) {
            const StatedPoint& point = id_.points[row];
            const std::size_t j = point.joint - 1;
            if (j >= id_.trajectories.size()) {
                problems_.error(place(&Identification::points, row, &StatedPoint::joint),
                                tell<"the robot has no %1">(joint_words(j)));
                continue;
            }
            id_.trajectories[j].points.push_back(point.p);
            id_.trajectories[j].rows.push_back(row);
            if (point.q) readings_[j].push_back(*point.q);
        }
        for (std::size_t j = 0; j < id_.trajectories.size(); ++j)
            if (id_.trajectories[j].points.size() < 3)
                problems_.error(place(&Identification::points),
                                tell<"%1 has %2 points; a circle needs three or more">(
                                    joint_words(j), id_.trajectories[j].points.size()));
    }

    void add_inputs() {
        std::vector<LocatedPoint> points;
        for (std::size_t j = 0; j < id_.trajectories.size(); ++j) {
            id_.trajectories[j].first_input = id_.inputs.quantities.size();
            for (std::size_t k = 0; k < id_.trajectories[j].points.size(); ++k)
                points.push_back(add_point(j, k));
        }
        add_point_components(id_.locator, points, id_.inputs, problems_);
    }

    LocatedPoint add_point(std::size_t j, std::size_t k) {
        static const char* const axes[] = {"x", "y", "z"};
        const Trajectory& t = id_.trajectories[j];
        LocatedPoint point{t.points[k], std::to_string(j + 1) + "," + std::to_string(k + 1),
                           id_.inputs.quantities.size()};
        for (int c = 0; c < 3; ++c) {
            InputQuantity quantity{.symbol = std::string(axes[c]) + "_" + point.label,
                                   .name = tell<"%1, point %2, %3">(joint_words(j), k + 1, axes[c]),
                                   .unit = Unit::of("mm"),
                                   .offset = t.points[k][c],
                                   .group = joint_name(j)};
            if (!t.rows.empty()) quantity.source = place(&Identification::points, t.rows[k]);
            quantity.tags = {{"trajectory", joint_name(j)}};
            id_.inputs.quantities.push_back(std::move(quantity));
        }
        return point;
    }

    /// Root mean square of the standard uncertainties of the coordinates of a trajectory.
    double noise_of(const Trajectory& t) const {
        double squares = 0.0;
        for (std::size_t i = 0; i < 3 * t.points.size(); ++i)
            squares += std::pow(standard_uncertainty_of(id_.inputs, t.first_input + i), 2);
        return std::sqrt(squares / static_cast<double>(3 * t.points.size()));
    }

    void shape(std::size_t j) {
        Trajectory& t = id_.trajectories[j];
        t.shape = circle_shape(t.points);
        const double u = std::max(noise_of(t), 1e-9);
        const std::string where =
            id_.simulated ? place(&Identification::ball) : place(&Identification::points);
        if (t.shape.extents[0] < 10.0 * u)
            return problems_.error(
                where, tell<"the ball hardly moves while %1 turns: it lies on the axis of that joint and "
                            "draws no circle. Fix the ball off the axis">(joint_words(j)));
        if (t.shape.extents[1] < 2.0 * u)
            return problems_.error(
                where, tell<"the points of %1 lie on a straight line, as far as their uncertainty lets it be "
                            "seen: no circle goes through them. Turn the joint further">(joint_words(j)));
        if (t.shape.extents[1] < 10.0 * u)
            problems_.warning(where,
                              tell<"the arc of %1 over %2 is short for the uncertainty of its points: its "
                                   "axis will be known poorly">(joint_words(j), degrees(t.shape.arc)));
        orient(j);
        refine(j);
        const Eigen::Vector3d n = t.shape.start.axes.col(2);
        const double distance = std::abs(n.dot(t.shape.start.centre));
        if (id_.plane == PlaneFit::equation_1 && distance < 0.02 * t.shape.start.radius)
            problems_.warning(
                place(&Identification::plane),
                tell<"the plane of %1 passes the origin at %2: Eq 1 excludes planes through the origin and "
                     "fails near it. Use total least squares">(joint_words(j), millimetres(distance)));
    }

    /// Normal along the positive direction of the joint: by the readings where they are given, else by the
    /// order of the points.
    void orient(std::size_t j) {
        Trajectory& t = id_.trajectories[j];
        double sign = id_.robot().joints()[j].direction;
        if (!id_.simulated && readings_[j].size() == t.points.size())
            sign *= readings_[j].back() >= readings_[j].front() ? 1.0 : -1.0;
        else
            sign = 1.0;
        if (id_.simulated) sign = 1.0;
        if (sign > 0.0) return;
        t.shape.start.axes.col(1) *= -1.0;
        t.shape.start.axes.col(2) *= -1.0;
    }

    /// The geometric fit from the algebraic start, so that trials start at the estimate.
    void refine(std::size_t j) {
        Trajectory& t = id_.trajectories[j];
        const auto point = [&](std::size_t k) { return Vector3<double>(t.points[k]); };
        SpaceCircle<double> circle{};
        for (int k = 0; k < 5; ++k) {
            circle = fit_circle<double>(t.shape.start, point, t.points.size(), id_.plane);
            if (!circle.centre.allFinite() || !circle.normal.allFinite()) break;
            t.shape.start.centre = circle.centre;
            t.shape.start.radius = circle.radius;
            Eigen::Matrix3d& axes = t.shape.start.axes;
            axes.col(2) = circle.normal;
            axes.col(0) = (axes.col(0) - circle.normal * circle.normal.dot(axes.col(0))).normalized();
            axes.col(1) = axes.col(2).cross(axes.col(0));
        }
        if (!circle.converged)
            problems_.error(
                id_.simulated ? place(&Identification::half_range) : place(&Identification::points),
                tell<"no circle fits the points of %1; look for exchanged points">(joint_words(j)));
    }

    Problems& problems_;
    Identification id_;
    std::vector<std::vector<double>> readings_;  ///< measured, of each joint
};

}  // namespace

std::optional<Identification> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems) {
    StatedIdentification stated = fields().read(setup, assets, problems);
    if (problems.has_errors()) return {};
    return Reading(std::move(stated), problems).read();
}

}  // namespace covaria::circle_points
