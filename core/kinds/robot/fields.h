// Fields of a serial robot.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/robot/serial_robot.h"
#include "core/setup/fields.h"

namespace covaria {

/// More joints than any arm in the library has.
inline constexpr std::size_t most_joints = 7;

/// Figures by JointParameter; empty where none is given.
using StatedParameters = std::array<std::optional<double>, joint_parameters.size()>;
inline std::size_t index_of(JointParameter parameter) {
    return static_cast<std::size_t>(parameter);
}

/// A row of the table of joints, SI.
struct StatedJoint {
    enum Figure { zero, low, high, u_encoder, u_repeatability };
    using Figures = std::array<std::optional<double>, 5>;
    StatedParameters values;
    Figures turning, sliding;  ///< of readings: angles of a joint that turns, lengths of one that slides
    bool against = false;      ///< the joint angle falls with the reading
    bool slides = false;
    std::optional<std::size_t> moved_by;  ///< number from 1 of the joint that moves this one along
    std::optional<double> share;
    Figures StatedJoint::*own() const { return slides ? &StatedJoint::sliding : &StatedJoint::turning; }
};

/// A row of the components of uncertainty.
struct StatedUncertainty {
    std::string source;
    std::optional<std::size_t> joint;  ///< number of the joint from 1; empty: all
    StatedParameters u;
    std::optional<double> degrees_of_freedom;
    std::string distribution;
};

struct StatedCorrelation {
    std::string first, second;
    double coefficient = 0.0;
};

/// The set-up as typed, SI.
struct StatedRobot {
    enum class Convention { modified, standard, craig };
    Convention convention = Convention::modified;
    std::vector<StatedJoint> joints;
    Eigen::Isometry3d base = Eigen::Isometry3d::Identity(), tool = Eigen::Isometry3d::Identity();
    std::vector<StatedUncertainty> uncertainties;
    std::vector<StatedCorrelation> correlations;
    double u_tool_position = 0.0, u_tool_angle = 0.0;
};
const Fields<StatedRobot>& robot_fields();

/// Readings of a pose, one for each joint, which turns or slides. Empty where none is given.
using StatedReadings = std::array<std::optional<double>, most_joints>;
/// Columns q_1, q_2 ... with that letter; `help` goes on after "Reading of joint 1".
std::array<ColumnSpec, most_joints> reading_columns(const std::string& letter, const Unit& unit,
                                                    const std::string& help);

}  // namespace covaria
