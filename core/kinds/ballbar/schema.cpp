// The fields of "TCP from ballbars".
#include "core/kinds/ballbar/setup.h"

namespace covaria::tcp {

namespace {

const Unit mm = Unit::of("mm");
const Unit deg = Unit::of("deg");
using Rotation = StatedTcp::Rotation;
using Measured = StatedTcp::Measured;
using Place = StatedTcp::Place;

const std::vector<ChoiceOf<int>> axes{{0, "x", "x"}, {1, "y", "y"}, {2, "z", "z"}};

ColumnSpec axis_column() {
    return {.key = "axis", .title = "axis", .help = "Axis of the flange about which the robot turns."};
}

std::array<ColumnSpec, 3> coordinates() {
    std::array<ColumnSpec, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string key(1, axis_letters[i]);
        columns[i] = {.key = key,
                      .title = key,
                      .unit = mm,
                      .help = "Coordinate " + key + " in the frame of the ballbars."};
    }
    return columns;
}

void add_measurement(Fields<StatedTcp>& fields) {
    fields
        .add(&StatedTcp::ballbars, {.key = "ballbars",
                                    .title = "Ballbars",
                                    .help = "The set of telescopic ballbars that measures the points.",
                                    .section = "Measurement"})
        .add(
            &StatedTcp::robot,
            {.key = "robot",
             .title = "Robot",
             .help = "Gives the repeatability with which the robot goes to the points; none: an ideal robot.",
             .optional = true,
             .section = "Measurement"})
        .choice(&StatedTcp::task,
                {.key = "evaluation",
                 .title = "Evaluation",
                 .help = "The tool centre point from a planned procedure or from measured points; or only "
                         "the points as the ballbars measure them.",
                 .section = "Measurement"},
                {{Task::plan, "plan", "tool centre point, planned procedure"},
                 {Task::measured, "measured", "tool centre point, measured points"},
                 {Task::points, "points", "points alone"}},
                Task::plan);
}

FieldSpec tool_field(const char* key, const char* axis) {
    return {.key = key,
            .title = std::string("Tool ") + axis,
            .help = std::string("Nominal coordinate ") + axis +
                    " of the tool centre point in the flange's frame.",
            .unit = mm,
            .default_value = Quantity{0.0, mm},
            .section = "Procedure"};
}

void add_flange(Fields<StatedTcp>& fields) {
    fields
        .add(&StatedTcp::flange,
             {.key = "flange",
              .title = "Flange",
              .help = "Pose of the flange in the robot's frame before it turns; its origin is the centre "
                      "of the sphere on which the ball moves.",
              .default_value = PoseValue{},
              .section = "Procedure"})
        .add(&StatedTcp::tool_x, tool_field("tool_x", "x"))
        .add(&StatedTcp::tool_y, tool_field("tool_y", "y"))
        .add(&StatedTcp::tool_z, tool_field("tool_z", "z"));
}

Columns<Rotation> rotation_columns() {
    return Columns<Rotation>()
        .choice(&Rotation::axis, axis_column(), axes)
        .add(&Rotation::start,
             {.key = "start", .title = "start", .unit = deg, .help = "Angle at the first point."})
        .add(&Rotation::span,
             {.key = "span",
              .title = "span",
              .unit = deg,
              .help = "Angle from the first point to the last; negative: turned the other way."})
        .add(&Rotation::points, {.key = "points",
                                 .title = "points",
                                 .range = {.low = 3.0, .high = 200.0},
                                 .help = "Number of points, equally spaced from the first to the last."});
}

Columns<Measured> measured_columns() {
    return Columns<Measured>()
        .choice(&Measured::axis, axis_column(), axes)
        .add(&Measured::angle,
             {.key = "angle", .title = "angle", .unit = deg, .help = "Commanded angle of rotation."})
        .vector(&Measured::p_B, coordinates());
}

Columns<Place> place_columns() {
    return Columns<Place>()
        .add(&Place::name, {.key = "name", .title = "name", .help = "Name of the point, unique."})
        .vector(&Place::p_B, coordinates());
}

void add_points(Fields<StatedTcp>& fields) {
    fields
        .table(
            &StatedTcp::rotations,
            {.key = "sequences",
             .title = "Rotations",
             .help = "Two or three rotations of the flange about its own axes, its origin held in place: the "
                     "ball traces an arc in each.",
             .min_rows = 2,
             .section = "Procedure"},
            rotation_columns())
        .table(&StatedTcp::measured,
               {.key = "measured_points",
                .title = "Measured points",
                .help = "Points as measured, each with the axis of its rotation and the commanded angle, "
                        "typed or from a CSV file.",
                .section = "Procedure"},
               measured_columns())
        .table(&StatedTcp::places,
               {.key = "points",
                .title = "Points",
                .help = "Places of the ball that are measured, typed or from a CSV file.",
                .min_rows = 1,
                .section = "Procedure"},
               place_columns());
}

std::vector<ChoiceOf<FrameRule>> frame_choices() {
    std::vector<ChoiceOf<FrameRule>> choices;
    for (const FrameRule& rule : frame_rules) choices.push_back({rule, rule.key, rule.title});
    return choices;
}

void add_fit(Fields<StatedTcp>& fields) {
    fields
        .choice(&StatedTcp::frame,
                {.key = "frame",
                 .title = "Axes of the flange",
                 .help = "Measured axes are not exactly perpendicular: which one is kept as measured. A "
                         "third measured axis then only helps the sphere and the mean.",
                 .section = "Fit"},
                frame_choices(), frame_rules[0])
        .choice(&StatedTcp::geometric_sphere,
                {.key = "sphere",
                 .title = "Centre of the flange",
                 .help = "Sphere through all points by linear least squares, or refined to least distances "
                         "from it.",
                 .section = "Fit"},
                {{true, "geometric", "sphere, geometric fit from the linear one"},
                 {false, "linear", "sphere, linear fit"}},
                true);
}

Fields<StatedTcp> declared() {
    Fields<StatedTcp> fields;
    add_measurement(fields);
    add_flange(fields);
    add_points(fields);
    add_fit(fields);
    fields
        .shown_where(&StatedTcp::task, {Task::plan}, &StatedTcp::flange, &StatedTcp::tool_x,
                     &StatedTcp::tool_y, &StatedTcp::tool_z, &StatedTcp::rotations)
        .shown_where(&StatedTcp::task, {Task::measured}, &StatedTcp::measured)
        .shown_where(&StatedTcp::task, {Task::points}, &StatedTcp::places)
        .shown_where(&StatedTcp::task, {Task::plan, Task::measured}, &StatedTcp::frame,
                     &StatedTcp::geometric_sphere);
    return fields;
}

}  // namespace

const Fields<StatedTcp>& tcp_fields() {
    static const Fields<StatedTcp> fields = declared();
    return fields;
}

}  // namespace covaria::tcp
