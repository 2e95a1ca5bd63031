// Fields of the identification from measured poses.
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot_identification/from_poses.h"

namespace covaria::pose_calibration {

namespace {

const Condition simulated{"data", {"simulated"}};
const Condition measured{"data", {"measured"}};
const Condition with_orientation{"quantity", {"poses"}};

FieldSpec poses_field() {
    const Unit mm = Unit::of("mm"), deg = Unit::of("deg");
    FieldSpec field{.key = "poses",
                    .title = "Measured poses",
                    .kind = FieldKind::table,
                    .help =
                        "Readings of the joints and the place of the ball or tool that was measured there; "
                        "typed or from a CSV file.",
                    .optional = true,
                    .shown_if = measured,
                    .section = "Poses"};
    field.columns = {{.key = "name", .title = "name", .kind = FieldKind::text, .help = "Name, unique."},
                     {.key = "use",
                      .title = "use",
                      .kind = FieldKind::choice,
                      .optional = true,
                      .choices = {{"fit", "fit"}, {"check", "check"}},
                      .help = "fit: taken into the fit. check: held back, to see how well the fit tells a "
                              "pose that it has not seen. Empty: fit."}};
    for (std::size_t i = 1; i <= most_joints; ++i)
        field.columns.push_back(
            {.key = "q_" + std::to_string(i),
             .title = "q_" + std::to_string(i),
             .unit = deg,
             .optional = true,
             .help = "Reading of joint " + std::to_string(i) + "; empty: its zero reading."});
    for (const char* axis : {"x", "y", "z"})
        field.columns.push_back({.key = axis,
                                 .title = axis,
                                 .unit = mm,
                                 .help = std::string("Measured coordinate ") + axis +
                                         " in the frame of the instrument's world."});
    for (const char* angle : {"alpha", "beta", "gamma"})
        field.columns.push_back({.key = angle,
                                 .title = angle,
                                 .unit = deg,
                                 .optional = true,
                                 .help =
                                     "Measured orientation, R = Rz(gamma) Ry(beta) Rx(alpha), where poses "
                                     "are measured."});
    return field;
}

std::vector<FieldSpec> simulation_fields() {
    return {
        {.key = "pose_count",
         .title = "Number of poses",
         .kind = FieldKind::integer,
         .help = "Poses of the simulated experiment, spread over the range of all joints, always the same.",
         .range = {.low = 3.0, .high = 1000.0},
         .default_value = Quantity{50.0, Unit()},
         .shown_if = simulated,
         .section = "Poses"},
        {.key = "half_range",
         .title = "Range of each joint, ±",
         .help = "From the zero reading on, as far as the limits of the joint allow.",
         .unit = Unit::of("deg"),
         .range = {.low = 0.0, .high = 3.1416, .low_open = true},
         .default_value = Quantity{90.0, Unit::of("deg")},
         .shown_if = simulated,
         .section = "Poses"}};
}

FieldSpec fitted_or_known(const char* key, const char* title, const char* help) {
    return {.key = key,
            .title = title,
            .kind = FieldKind::choice,
            .help = help,
            .default_value = std::string("fitted"),
            .choices = {{"fitted", "found by the fit"}, {"known", "known exactly"}},
            .section = "Method"};
}

std::vector<FieldSpec> method_fields() {
    FieldSpec held{.key = "held",
                   .title = "Parameters held",
                   .kind = FieldKind::table,
                   .help = "Parameters that stay nominal although the poses could tell them.",
                   .optional = true,
                   .section = "Method"};
    held.columns = {{.key = "parameter",
                     .title = "parameter",
                     .kind = FieldKind::text,
                     .help = "A parameter by its symbol, such as d_3 or alpha_4."}};
    return {
        {.key = "ball",
         .title = "Ball or tool",
         .kind = FieldKind::pose,
         .help = "Where it is in the frame of the last link: exactly, or as a start of the fit.",
         .default_value = PoseValue{.position = {80.0, 60.0, 40.0}},
         .section = "Method"},
        fitted_or_known("tool_place", "Place of the ball or tool is",
                        "Found by the fit together with the parameters, or known."),
        fitted_or_known("base_place", "Place of the base is",
                        "Found by the fit: the instrument stands anywhere. Known: the base stands where the "
                        "robot says it stands in the world."),
        held};
}

}  // namespace

std::vector<FieldSpec> fields() {
    std::vector<FieldSpec> all{
        {.key = "nominal",
         .title = "Nominal robot",
         .kind = FieldKind::reference,
         .help =
             "The arm as designed: start of the fit, values of what the poses cannot tell, uncertainty of "
             "the readings of its joints, and the arm of a simulation.",
         .capabilities = {SerialRobotSource::capability},
         .section = "Robot"},
        {.key = "data",
         .title = "Poses are",
         .kind = FieldKind::choice,
         .help = "Measured: a table. Simulated: those of the nominal robot, to see what an experiment would "
                 "give.",
         .default_value = std::string("simulated"),
         .choices = {{"measured", "measured"}, {"simulated", "simulated"}},
         .section = "Poses"},
        {.key = "quantity",
         .title = "Measured is",
         .kind = FieldKind::choice,
         .help = "The position of a ball alone, or position and orientation of the tool.",
         .default_value = std::string("positions"),
         .choices = {{"positions", "the position"}, {"poses", "position and orientation"}},
         .section = "Poses"},
        poses_field()};
    const auto add = [&](const std::vector<FieldSpec>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    add(simulation_fields());
    add(locator_fields().schema().fields());
    all.push_back({.key = "u_angle",
                   .title = "Standard uncertainty of an orientation",
                   .help = "Of the rotation of the measured tool about each of its axes, independent.",
                   .unit = Unit::of("deg"),
                   .range = {.low = 0.0},
                   .default_value = Quantity{0.005, Unit::of("deg")},
                   .shown_if = with_orientation,
                   .section = "Points"});
    add(method_fields());
    return all;
}

}  // namespace covaria::pose_calibration
