// Options of the commands that read a robot from URDF.
#pragma once

#include <string>
#include <vector>

#include "core/kinds/robot/urdf.h"

namespace CLI {
class App;
}

namespace covaria {

/// Adds --tip and --freeze; both must outlive the parser.
void add_robot_options(CLI::App& command, std::string& tip, std::vector<std::string>& frozen);
/// `frozen`: "NAME=VALUE" each.
Result<UrdfChoice> urdf_choice(const std::string& tip, const std::vector<std::string>& frozen);

}  // namespace covaria
