// The set-up of "robot pose", read and checked.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/robot/fields.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/math/rotation_convention.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"

namespace covaria::robot {

inline constexpr std::size_t no_input = InputSet::npos;

struct Pose {
    std::string name;
    std::string source;                            ///< place in the set-up
    std::vector<double> q = {};                    ///< readings of the joints, rad or m
    std::array<std::size_t, most_joints> input{};  ///< index of each reading, or no_input: it is exact
};

/// A row of the poses by joint readings.
struct StatedPose {
    std::string name;
    StatedReadings q, s;
};

/// A row of the poses by place of the tool, in the base frame.
struct StatedPlace {
    std::string name;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::array<std::optional<double>, 3> angles;  ///< alpha, beta, gamma
};

struct PoseSetup {
    Offered<SerialRobotSource> arm;
    std::vector<StatedPose> stated;
    std::vector<StatedPlace> places;
    std::vector<Pose> poses;  ///< poses of both tables
    std::optional<RotationConvention> orientation;
    bool in_world = false;   ///< results in the world frame instead of the robot's base
    bool combine = false;    ///< components of a parameter drawn as one
    bool correlated = true;  ///< the robot's correlation of parameters is used
    /// Input of each parameter: [joint][JointParameter]; no_input: it is 0 by definition.
    std::array<std::array<std::size_t, 5>, most_joints> parameter{};
    std::size_t tool = no_input;  ///< first of six deviations

    const SerialRobotSource& robot() const { return *arm; }
    std::size_t outputs_per_pose() const {
        return 3 + (orientation ? rotation_convention(*orientation).coordinates.size() : 0);
    }
};

const Fields<PoseSetup>& pose_fields();
/// Empty if `problems` got an error; warns of readings beyond the limits.
std::optional<PoseSetup> read_pose_setup(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems);
/// Fills in the indices of the inputs.
InputSet pose_inputs(PoseSetup& setup);
std::vector<Table> pose_evaluation(const PoseSetup& setup);

}  // namespace covaria::robot
