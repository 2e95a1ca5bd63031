// Robots from URDF, the robot description format of ROS.
#include "core/kinds/robot/urdf.h"

#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"

namespace covaria {

namespace {

/// Recognises URDF, and Xacro, which is URDF before its macros are expanded; reading it says so.
Recognition recognise_urdf(std::string_view beginning, const std::string& file_name) {
    const bool named = file_name.ends_with(".urdf") || file_name.ends_with(".xacro");
    if (beginning.find("<robot") == std::string_view::npos) return Recognition::no;
    return named || beginning.find("<joint") != std::string_view::npos ||
                   beginning.find("<link") != std::string_view::npos
               ? Recognition::certain
               : Recognition::possible;
}

Result<Proposals> read_urdf(const std::string& text, const ReadChoice& choice) {
    auto robot = import_urdf(text, choice.robot);
    if (!robot) return fail(robot.error());
    Proposals proposals{.title = robot->name, .found = std::move(robot->report)};
    proposals.assets.push_back(
        {id_of(robot->name, "robot"), robot->kind, robot->name, robot->notes, std::move(robot->setup)});
    return proposals;
}

}  // namespace

Reader urdf_reader() {
    return {.name = "urdf",
            .title = "Robot description (URDF)",
            .pattern = "*.urdf",
            .takes = "the arm from the root link to its tip -> serial robot",
            .recognise = recognise_urdf,
            .read = read_urdf};
}

}  // namespace covaria
