#include "core/kinds/robot/arm_frames.h"

#include "core/kinds/robot/serial_robot.h"

namespace covaria {

namespace {

Eigen::Isometry3d along_z(double angle, double length) {
    Eigen::Isometry3d X(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    X.translation().z() = length;
    return X;
}

/// Rx(alpha) with the translation a along x.
Eigen::Isometry3d along_x(double angle, double length) {
    Eigen::Isometry3d X(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()));
    X.translation().x() = length;
    return X;
}

/// Transforms before and behind the movement of a joint.
struct AroundMovement {
    Eigen::Isometry3d before, behind;
};

/// A joint whose reading counts the other way moves about the z-axis turned over: Z(-q) = Rx(pi) Z(q)
/// Rx(-pi).
AroundMovement around(const std::vector<RobotJoint>& joints, std::size_t i, DhConvention convention) {
    const RobotJoint& joint = joints[i];
    const JointValues<double>& v = joint.values;
    const double zero = travel_of(joints, i, std::vector<double>(joints.size(), 0.0));
    const Eigen::Isometry3d own = joint.slides ? along_z(v.theta, v.d + zero) : along_z(v.theta + zero, v.d);
    const Eigen::Isometry3d link = along_x(v.alpha, v.a);
    AroundMovement around{Eigen::Isometry3d::Identity(), own};
    if (convention == DhConvention::craig)
        around.before = link;
    else
        around.behind = own * link * Eigen::AngleAxisd(v.beta, Eigen::Vector3d::UnitY());
    if (joint.direction > 0) return around;
    Eigen::Isometry3d over = Eigen::Isometry3d::Identity();
    over.linear().diagonal() << 1.0, -1.0, -1.0;
    return {around.before * over, over * around.behind};
}

}  // namespace

std::optional<ArmFrames> arm_frames(const Asset* asset) {
    const auto* robot = offers<SerialRobotSource>(asset);
    if (!robot) return {};
    ArmFrames arm;
    arm.X_WB = robot->X_WB();
    arm.first_coupled = first_coupled_joint(*robot);
    for (std::size_t i = 0; i < robot->joints().size(); ++i) {
        const RobotJoint& joint = robot->joints()[i];
        const AroundMovement parts = around(robot->joints(), i, robot->convention());
        arm.joints.push_back({arm.X_JT * parts.before, joint.slides, joint.low, joint.high});
        arm.X_JT = parts.behind;
        for (const JointParameter p : joint_parameters)
            if (joint.has(p))
                arm.parameters.push_back({i, std::string(symbol_of(p)) + "_" + std::to_string(i + 1),
                                          is_length(p), joint.values[p],
                                          standard_uncertainty_of(*robot, i, p), robot->taken_from(i, p)});
    }
    arm.X_JT = arm.X_JT * robot->X_FT();
    return arm;
}

}  // namespace covaria
