// Parameters of an arm that an identification finds: their tables, and the arm that has them. Shared by all
// ways of identification.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/kinds/robot/arm.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/text/table.h"

namespace covaria {

struct IdentifiedParameter {
    std::size_t joint = 0;
    JointParameter parameter = JointParameter::theta;
    std::string symbol() const { return std::string(symbol_of(parameter)) + "_" + std::to_string(joint + 1); }
};

/// A parameter that stays as it is, and why.
struct HeldParameter {
    Message parameter, reason;
};

/// Why its d stays: an axis that is parallel to the next.
Message parallel_to_the_next();

/// Value next to the nominal one: angles without whole turns in between.
double next_to(double nominal, JointParameter parameter, double value);
/// "nominal", "identified", "difference", and u where `covariance` is not empty. Values in SI.
Table identified_table(const SerialRobotSource& nominal, const std::vector<IdentifiedParameter>& found,
                       const std::vector<double>& values, const Eigen::MatrixXd& covariance = {});
Table held_table(const std::vector<HeldParameter>& held);
/// The nominal arm with the found values, without uncertainties.
RobotData identified_robot(const SerialRobotSource& nominal, const std::vector<IdentifiedParameter>& found,
                           const std::vector<double>& values);
/// Its joints are read as surely as those of `robot`.
void take_reading_uncertainties(const SerialRobotSource& robot, RobotData& data);
/// The robot whose found parameters are outputs of the analysis `analysis`: group "joint 3", by symbol.
std::shared_ptr<const Asset> robot_of_analysis(RobotData data, const std::vector<IdentifiedParameter>& found,
                                               const std::string& analysis);

}  // namespace covaria
