#include "core/kinds/robot/inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/kinds/robot/serial_robot.h"
#include "core/math/decompositions.h"
#include "core/math/rotation.h"

namespace covaria::robot {

namespace {

constexpr int attempts = 48, most_steps = 200;
constexpr double close_enough = 1e-10;  // m and rad

class InverseSolver {
public:
    InverseSolver(const SerialRobotSource& robot, const Target& target) : robot_(robot), target_(target) {
        for (const Eigen::Isometry3d& X : link_frames(robot, std::vector<double>(robot.joints().size(), 0.0)))
            reach_ = std::max(reach_, X.translation().norm());
        reach_ = std::max({reach_, 1e-3, first_sliding_joint(robot) > 0 ? target.position.norm() : 0.0});
    }

    double reach() const { return reach_; }

    InverseSolution from(std::vector<double> q) const {
        Eigen::VectorXd e = miss(q);
        double damping = 1e-3;
        for (int step = 0; step < most_steps && e.norm() > close_enough; ++step) {
            const Eigen::MatrixXd J = derivative(q);
            Eigen::MatrixXd N = J.transpose() * J;
            N.diagonal().array() += damping * damping;
            const auto dq = damped_step(N, J.transpose() * e);
            std::vector<double> next = dq ? moved(q, *dq) : q;
            const Eigen::VectorXd e_next = miss(next);
            const bool better = dq && e_next.norm() < e.norm();
            damping = better ? damping / 4.0 : damping * 3.0;
            if (better) {
                q = std::move(next);
                e = e_next;
            } else if (damping > 1e3) {
                break;
            }
        }
        const double distance = e.head<3>().norm() * reach_;
        return {e.norm() < 1e-8 ? q : std::vector<double>{}, distance};
    }

private:
    std::vector<double> moved(std::vector<double> q, const Eigen::VectorXd& dq) const {
        for (std::size_t i = 0; i < q.size(); ++i) {
            const RobotJoint& joint = robot_.joints()[i];
            const double scale = joint.slides ? reach_ : 1.0;
            q[i] = std::clamp(q[i] + scale * dq[static_cast<Eigen::Index>(i)], joint.low, joint.high);
        }
        return q;
    }

    /// Position over the reach, then the rotation vector.
    Eigen::VectorXd miss(const std::vector<double>& q) const {
        const Eigen::Isometry3d X = link_frames(robot_, q).back();
        Eigen::VectorXd e(target_.orientation ? 6 : 3);
        e.head<3>() = (target_.position - X.translation()) / reach_;
        if (target_.orientation)
            e.tail<3>() =
                rotation_vector_from_rotation<double>(*target_.orientation * X.linear().transpose());
        return e;
    }

    Eigen::MatrixXd derivative(const std::vector<double>& q) const {
        const std::vector<Eigen::Isometry3d> frames = link_frames(robot_, q);
        const Eigen::Vector3d p = frames.back().translation();
        Eigen::MatrixXd J(target_.orientation ? 6 : 3, static_cast<Eigen::Index>(q.size()));
        J.setZero();
        const std::vector<RobotJoint>& joints = robot_.joints();
        for (std::size_t i = 0; i < q.size(); ++i) {
            const Eigen::Isometry3d& X = frames[robot_.convention() == DhConvention::craig ? i + 1 : i];
            const bool slides = joints[i].slides;
            const auto add = [&](std::size_t reading, double by) {
                const Eigen::Vector3d z = by * X.linear().col(2);
                const auto column = static_cast<Eigen::Index>(reading);
                // A sliding joint moves by its share of the reach, so that all columns have the same size.
                J.col(column).head<3>() +=
                    slides ? z : Eigen::Vector3d(z.cross(p - X.translation()) / reach_);
                if (target_.orientation && !slides) J.col(column).tail<3>() += z;
            };
            add(i, joints[i].direction);
            if (const std::size_t other = joints[i].moved_by; other != RobotJoint::alone)
                add(other, joints[i].share * joints[other].direction);
        }
        return J;
    }

    const SerialRobotSource& robot_;
    const Target& target_;
    double reach_ = 0.0;
};

/// Readings of attempt k: an additive recurrence over the range of every joint (Roberts' sequence), the same
/// at every call.
std::vector<double> readings_of_attempt(const SerialRobotSource& robot, double reach, int k) {
    std::vector<double> q;
    double share = 0.5;
    for (std::size_t i = 0; i < robot.joints().size(); ++i) {
        const RobotJoint& joint = robot.joints()[i];
        const double range = joint.slides ? reach : std::numbers::pi;
        const double low = std::max(joint.low, joint.zero - range);
        const double high = std::min(joint.high, joint.zero + range);
        share = std::fmod(std::sqrt(double(i + 2) * 7.0) * k, 1.0);
        q.push_back(low + share * (high - low));
    }
    return q;
}

double distance_between(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

/// Whole turns are taken off as far as the limits allow.
void unwind(const SerialRobotSource& robot, const std::vector<double>& start, std::vector<double>& q) {
    constexpr double turn = 2.0 * std::numbers::pi;
    for (std::size_t i = 0; i < q.size(); ++i) {
        const RobotJoint& joint = robot.joints()[i];
        if (joint.slides) continue;
        const double near = start[i] + std::remainder(q[i] - start[i], turn);
        if (near >= joint.low && near <= joint.high) q[i] = near;
    }
}

}  // namespace

InverseSolution solve_inverse(const SerialRobotSource& robot, const Target& target,
                              const std::vector<double>& start) {
    const InverseSolver solver(robot, target);
    InverseSolution best = solver.from(start);
    for (int k = 1; k <= attempts; ++k) {
        InverseSolution found = solver.from(readings_of_attempt(robot, solver.reach(), k));
        if (!found.q.empty()) unwind(robot, start, found.q);
        const bool nearer = !found.q.empty() && (best.q.empty() || distance_between(found.q, start) + 1e-9 <
                                                                       distance_between(best.q, start));
        if (nearer || (best.q.empty() && found.distance < best.distance)) best = std::move(found);
    }
    return best;
}

}  // namespace covaria::robot
