#include "app/frozen_joints.h"

#include <CLI/CLI.hpp>
#include <sstream>

namespace covaria {

void add_robot_options(CLI::App& command, std::string& tip, std::vector<std::string>& frozen) {
    command.add_option("--tip", tip, "of a robot (URDF): link at the end of the arm; found without it")
        ->type_name("LINK");
    command
        .add_option("--freeze", frozen,
                    "joint of a robot (URDF) that the arm does not have, at a value in degrees or "
                    "millimetres: a rail, a turntable; repeat for more")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

Result<UrdfChoice> urdf_choice(const std::string& tip, const std::vector<std::string>& frozen) {
    UrdfChoice choice{.tip = tip, .frozen = {}};
    for (const std::string& text : frozen) {
        const std::size_t sign = text.rfind('=');
        FrozenJoint joint;
        std::istringstream value(sign == std::string::npos ? std::string() : text.substr(sign + 1));
        if (sign == 0 || !(value >> joint.value) || !(value >> std::ws).eof())
            return fail(ErrorCode::bad_input, "--freeze " + text +
                                                  ": write NAME=VALUE, in degrees for a joint that turns, in "
                                                  "millimetres for one that slides");
        joint.name = text.substr(0, sign);
        choice.frozen.push_back(std::move(joint));
    }
    return choice;
}

}  // namespace covaria
