// Kinematic calibration of an arm of six turning joints, as the ROS driver of UR robots reads it.
#include <array>
#include <cmath>
#include <cstdint>

#include "core/setup/message_text.h"
#include "core/writers/exported_robot.h"
#include "core/writers/formats.h"

namespace covaria {

namespace {

constexpr std::array<const char*, 6> calibrated_links{"shoulder", "upper_arm", "forearm",
                                                      "wrist_1",  "wrist_2",   "wrist_3"};
constexpr double same_tool = 1e-12;  // in m and rad

/// The checksum FNV-1a, by which the driver tells calibrations apart.
std::uint64_t checksum_of(const std::string& text) {
    std::uint64_t hash = 14695981039346656037ull;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    return hash;
}

/// Puts the frame of wrist_3, behind which the file has none, where the whole tool is then in it: a tool that
/// turns about the axis of wrist_3 and lies along it belongs to that frame as well.
void join_tool(ArmFrames& arm, std::vector<std::string>& said) {
    const Eigen::Isometry3d& X = arm.X_JT;
    const bool along_axis = std::hypot(X.translation().x(), X.translation().y()) <= same_tool &&
                            std::hypot(X.linear()(0, 2), X.linear()(1, 2)) <= same_tool &&
                            X.linear()(2, 2) > 0;
    if (along_axis) {
        arm.joints.back().X_PJ = arm.joints.back().X_PJ * X;
        arm.X_JT.setIdentity();
    } else {
        said.push_back("the tool has no place in the file: it stands at " + pose_words(X) + " from wrist_3");
    }
}

std::string frame_text(const Eigen::Isometry3d& X) {
    const auto rpy = roll_pitch_yaw(X.linear());
    const std::array<double, 6> values{
        X.translation().x(), X.translation().y(), X.translation().z(), rpy[0], rpy[1], rpy[2]};
    constexpr std::array<const char*, 6> keys{"x", "y", "z", "roll", "pitch", "yaw"};
    std::string text;
    for (std::size_t i = 0; i < keys.size(); ++i)
        text += std::string("    ") + keys[i] + ": " + shortest_number(values[i] + 0.0) + "\n";
    return text;
}

Result<void> check_arm(const ExportedRobot& robot) {
    const auto& joints = robot.arm.joints;
    bool turning = joints.size() == calibrated_links.size();
    for (const ArmFrame& joint : joints) turning = turning && !joint.slides;
    if (turning) return {};
    return fail(ErrorCode::bad_input,
                tell<"robot %1: the file is of six joints that turn (shoulder to wrist_3); write it as URDF">(
                    robot.id));
}

Result<WrittenFile> write_calibration(const WriterSource& source) {
    auto robot = exported_robot(source);
    if (!robot) return fail(robot.error());
    if (auto checked = check_arm(*robot); !checked) return fail(checked.error());
    if (!robot->arm.X_WB.isApprox(Eigen::Isometry3d::Identity(), same_tool))
        robot->said.push_back("the shoulder is stated in the world frame, in which the base stands at " +
                              pose_words(robot->arm.X_WB));
    join_tool(robot->arm, robot->said);
    robot->arm.joints.front().X_PJ = robot->arm.X_WB * robot->arm.joints.front().X_PJ;
    std::string frames;
    for (std::size_t i = 0; i < calibrated_links.size(); ++i)
        frames += "  # joint " + std::to_string(i + 1) + ": " + robot->parameters[i] + "\n  " +
                  calibrated_links[i] + ":\n" + frame_text(robot->arm.joints[i].X_PJ);
    const std::string hash = "calib_" + std::to_string(checksum_of(frames));
    robot->said.push_back("hash " + hash +
                          " is that of these figures and not the controller's, of which the driver warns");
    return WrittenFile{
        "# Lengths in m, angles in rad, about fixed axes. Comments: parameters of the robot and "
        "their standard uncertainties u.\nkinematics:\n" +
            frames + "  hash: " + hash + "\n",
        robot->said};
}

}  // namespace

Writer robot_calibration_writer() {
    return {.name = "ur-calibration",
            .title = "Kinematic calibration of a UR robot (ROS)",
            .ending = ".yaml",
            .writes =
                "the robot of six turning joints that the analyses use or find, the identified before the "
                "nominal, with standard uncertainties of its parameters as comments",
            .write = write_calibration};
}

}  // namespace covaria
