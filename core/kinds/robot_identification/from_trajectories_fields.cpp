// Fields of the identification by joint trajectories.
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot_identification/from_trajectories.h"

namespace covaria::circle_points {

namespace {

const Condition simulated{"data", {"simulated"}};
const Condition measured{"data", {"measured"}};

FieldSpec points_field() {
    const Unit mm = Unit::of("mm");
    FieldSpec field{.key = "points",
                    .title = "Measured points",
                    .kind = FieldKind::table,
                    .help =
                        "Points of the ball at the flange in the order in which they were measured, joint by "
                        "joint, in the frame of the instrument's world; typed or from a CSV file.",
                    .optional = true,
                    .shown_if = measured,
                    .section = "Points"};
    field.columns = {{.key = "joint",
                      .title = "joint",
                      .kind = FieldKind::integer,
                      .range = {.low = 1.0, .high = double(most_joints)},
                      .help = "Number of the joint that turned."},
                     {.key = "q",
                      .title = "q",
                      .unit = Unit::of("deg"),
                      .optional = true,
                      .help = "Reading of that joint; says which way round the points run. Empty: with the "
                              "joint's positive direction."},
                     {.key = "x", .title = "x", .unit = mm, .help = "Coordinate x."},
                     {.key = "y", .title = "y", .unit = mm, .help = "Coordinate y."},
                     {.key = "z", .title = "z", .unit = mm, .help = "Coordinate z."}};
    return field;
}

std::vector<FieldSpec> simulation_fields() {
    return {
        {.key = "half_range",
         .title = "Range of each joint, ±",
         .help = "Each joint turns from its zero reading less this to its zero reading plus this.",
         .unit = Unit::of("deg"),
         .range = {.low = 0.0, .high = 3.1415, .low_open = true},
         .default_value = Quantity{60.0, Unit::of("deg")},
         .shown_if = simulated,
         .section = "Points"},
        {.key = "point_count",
         .title = "Points for each joint",
         .kind = FieldKind::integer,
         .help = "Number of points, evenly spaced over the range.",
         .range = {.low = 3.0, .high = 1000.0},
         .default_value = Quantity{50.0, Unit()},
         .shown_if = simulated,
         .section = "Points"},
        {.key = "ball",
         .title = "Ball",
         .kind = FieldKind::pose,
         .help =
             "Where the ball is in the frame of the last link. On the axis of a joint it draws no circle.",
         .default_value = PoseValue{.position = {80.0, 60.0, 40.0}},
         .shown_if = simulated,
         .section = "Points"}};
}

}  // namespace

std::vector<FieldSpec> fields() {
    std::vector<FieldSpec> all{
        {.key = "nominal",
         .title = "Nominal robot",
         .kind = FieldKind::reference,
         .help =
             "The arm as designed: directions of the frames, definitions of base and last link, and the arm "
             "of a simulation.",
         .capabilities = {SerialRobotSource::capability},
         .section = "Robot"},
        {.key = "data",
         .title = "Points are",
         .kind = FieldKind::choice,
         .help = "Measured: a table. Simulated: those of the nominal robot, to see what an experiment would "
                 "give.",
         .default_value = std::string("simulated"),
         .choices = {{"measured", "measured"}, {"simulated", "simulated"}},
         .section = "Points"},
        points_field()};
    for (const std::vector<FieldSpec>& more : {simulation_fields(), locator_fields().schema().fields()})
        all.insert(all.end(), more.begin(), more.end());
    all.push_back(
        {.key = "plane",
         .title = "Plane of a circle",
         .kind = FieldKind::choice,
         .help = "Total least squares fits any plane. Eq 1 of the paper has no plane through the origin "
                 "and fails near it.",
         .default_value = std::string("total"),
         .choices = {{"total", "total least squares"}, {"equation-1", "A x + B y + C z + 1 = 0 (Eq 1)"}},
         .section = "Method"});
    all.push_back(
        {.key = "parallel_limit",
         .title = "Axes are parallel below",
         .help = "Angle between two axes below which they are described by beta and not by their common "
                 "perpendicular, whose place is then hardly determined.",
         .unit = Unit::of("deg"),
         .range = {.low = 0.0, .high = 0.5},
         .default_value = Quantity{1.0, Unit::of("deg")},
         .section = "Method"});
    return all;
}

}  // namespace covaria::circle_points
