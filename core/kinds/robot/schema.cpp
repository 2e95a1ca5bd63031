// Fields of "robot pose".
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot/setup.h"

namespace covaria::robot {

namespace {

const Unit mm = Unit::of("mm");
const Unit deg = Unit::of("deg");

FieldSpec poses_field() {
    FieldSpec field{.key = "poses",
                    .title = "Poses by joint readings",
                    .kind = FieldKind::table,
                    .help =
                        "Readings of the joints, typed or from a CSV file. An empty cell is the zero "
                        "reading of the joint; a robot with fewer joints leaves the last columns empty.",
                    .optional = true,
                    .section = "Poses"};
    field.columns.push_back(
        {.key = "name", .title = "name", .kind = FieldKind::text, .help = "Name of the pose, unique."});
    for (std::size_t i = 1; i <= most_joints; ++i)
        field.columns.push_back({.key = "q_" + std::to_string(i),
                                 .title = "q_" + std::to_string(i),
                                 .unit = deg,
                                 .optional = true,
                                 .help = "Reading of joint " + std::to_string(i) + ", if it turns."});
    for (std::size_t i = 1; i <= most_joints; ++i)
        field.columns.push_back({.key = "s_" + std::to_string(i),
                                 .title = "s_" + std::to_string(i),
                                 .unit = mm,
                                 .optional = true,
                                 .help = "Reading of joint " + std::to_string(i) + ", if it slides."});
    return field;
}

FieldSpec targets_field() {
    FieldSpec field{.key = "targets",
                    .title = "Poses by place",
                    .kind = FieldKind::table,
                    .help =
                        "Places of the tool in the robot's base frame; the readings follow by inverse "
                        "kinematics, within the limits and near those of the pose before.",
                    .optional = true,
                    .section = "Poses"};
    field.columns = {{.key = "name", .title = "name", .kind = FieldKind::text, .help = "Name, unique."},
                     {.key = "x", .title = "x", .unit = mm, .help = "Coordinate x of the tool."},
                     {.key = "y", .title = "y", .unit = mm, .help = "Coordinate y of the tool."},
                     {.key = "z", .title = "z", .unit = mm, .help = "Coordinate z of the tool."}};
    for (const char* angle : {"alpha", "beta", "gamma"})
        field.columns.push_back({.key = angle,
                                 .title = angle,
                                 .unit = deg,
                                 .optional = true,
                                 .help = "Orientation, R = Rz(gamma) Ry(beta) Rx(alpha); all three empty: "
                                         "any orientation."});
    return field;
}

FieldSpec orientation_field() {
    FieldSpec field{.key = "orientation",
                    .title = "Orientation stated as",
                    .kind = FieldKind::choice,
                    .help = "Numbers that state the orientation of the tool; none: the position alone.",
                    .default_value = std::string("zyx"),
                    .choices = {{"none", "none (position alone)"}},
                    .section = "Results"};
    for (const RotationConventionInfo& info : rotation_conventions())
        field.choices.push_back({std::string(info.key), std::string(info.title)});
    return field;
}

}  // namespace

SetupSchema pose_schema() {
    return SetupSchema(
        {{.key = "robot",
          .title = "Robot",
          .kind = FieldKind::reference,
          .help = "The arm, with its parameters and their uncertainty.",
          .capabilities = {SerialRobotSource::capability},
          .section = "Robot"},
         {.key = "components",
          .title = "Components of a parameter",
          .kind = FieldKind::choice,
          .help = "Each by itself, so that the budget tells the sources apart; or combined into one normal "
                  "deviation, which needs fewer draws.",
          .default_value = std::string("separate"),
          .choices = {{"separate", "each by itself"}, {"combined", "combined into one"}},
          .section = "Robot"},
         {.key = "correlation",
          .title = "Correlation of the parameters",
          .kind = FieldKind::choice,
          .help = "Used as the robot states it; or ignored, as in the paper, to see what that does.",
          .default_value = std::string("used"),
          .choices = {{"used", "used"}, {"ignored", "ignored (the paper)"}},
          .section = "Robot"},
         poses_field(),
         targets_field(),
         orientation_field(),
         {.key = "frame",
          .title = "Results in",
          .kind = FieldKind::choice,
          .help = "The frame in which position and orientation are stated.",
          .default_value = std::string("base"),
          .choices = {{"base", "the base frame of the robot"}, {"world", "the world frame"}},
          .section = "Results"}});
}

}  // namespace covaria::robot
