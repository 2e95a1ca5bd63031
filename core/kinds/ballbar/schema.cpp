// The fields of "TCP from ballbars".
#include "core/kinds/ballbar/ballbar.h"
#include "core/kinds/ballbar/repeatability.h"
#include "core/kinds/ballbar/setup.h"

namespace covaria::tcp {

namespace {

const Unit mm = Unit::of("mm");
const Unit deg = Unit::of("deg");
const Condition when_planned{"evaluation", {"plan"}};
const Condition when_tool{"evaluation", {"plan", "measured"}};

ColumnSpec axis_column() {
    return {.key = "axis",
            .title = "axis",
            .kind = FieldKind::choice,
            .choices = {{"x", "x"}, {"y", "y"}, {"z", "z"}},
            .help = "Axis of the flange about which the robot turns."};
}

ColumnSpec coordinate(const char* key) {
    return {.key = key,
            .title = key,
            .unit = mm,
            .help = std::string("Coordinate ") + key + " in the frame of the ballbars."};
}

std::vector<FieldSpec> measurement_fields() {
    return {{.key = "ballbars",
             .title = "Ballbars",
             .kind = FieldKind::reference,
             .help = "The set of telescopic ballbars that measures the points.",
             .capabilities = {BallbarSource::capability},
             .section = "Measurement"},
            {.key = "robot",
             .title = "Robot",
             .kind = FieldKind::reference,
             .help = "Gives the repeatability with which the robot goes to the points; none: an ideal robot.",
             .optional = true,
             .capabilities = {RepeatabilitySource::capability},
             .section = "Measurement"},
            {.key = "evaluation",
             .title = "Evaluation",
             .kind = FieldKind::choice,
             .help = "The tool centre point from a planned procedure or from measured points; or only the "
                     "points as the ballbars measure them.",
             .default_value = std::string("plan"),
             .choices = {{"plan", "tool centre point, planned procedure"},
                         {"measured", "tool centre point, measured points"},
                         {"points", "points alone"}},
             .section = "Measurement"}};
}

FieldSpec tool_field(const char* key, const char* axis) {
    return {.key = key,
            .title = std::string("Tool ") + axis,
            .help = std::string("Nominal coordinate ") + axis +
                    " of the tool centre point in the flange's frame.",
            .unit = mm,
            .default_value = Quantity{0.0, mm},
            .shown_if = when_planned,
            .section = "Procedure"};
}

FieldSpec sequences_table() {
    FieldSpec table{.key = "sequences",
                    .title = "Rotations",
                    .kind = FieldKind::table,
                    .help =
                        "Two or three rotations of the flange about its own axes, its origin held in place: "
                        "the ball traces an arc in each.",
                    .min_rows = 2,
                    .shown_if = when_planned,
                    .section = "Procedure"};
    table.columns = {axis_column(),
                     {.key = "start", .title = "start", .unit = deg, .help = "Angle at the first point."},
                     {.key = "span",
                      .title = "span",
                      .unit = deg,
                      .help = "Angle from the first point to the last; negative: turned the other way."},
                     {.key = "points",
                      .title = "points",
                      .kind = FieldKind::integer,
                      .range = {.low = 3.0, .high = 200.0},
                      .help = "Number of points, equally spaced from the first to the last."}};
    return table;
}

FieldSpec measured_table() {
    FieldSpec table{.key = "measured_points",
                    .title = "Measured points",
                    .kind = FieldKind::table,
                    .help =
                        "Points as measured, each with the axis of its rotation and the commanded angle, "
                        "typed or from a CSV file.",
                    .shown_if = Condition{"evaluation", {"measured"}},
                    .section = "Procedure"};
    table.columns = {axis_column(),
                     {.key = "angle", .title = "angle", .unit = deg, .help = "Commanded angle of rotation."},
                     coordinate("x"),
                     coordinate("y"),
                     coordinate("z")};
    return table;
}

FieldSpec points_table() {
    FieldSpec table{.key = "points",
                    .title = "Points",
                    .kind = FieldKind::table,
                    .help = "Places of the ball that are measured, typed or from a CSV file.",
                    .min_rows = 1,
                    .shown_if = Condition{"evaluation", {"points"}},
                    .section = "Procedure"};
    table.columns = {
        {.key = "name", .title = "name", .kind = FieldKind::text, .help = "Name of the point, unique."},
        coordinate("x"),
        coordinate("y"),
        coordinate("z")};
    return table;
}

std::vector<FieldSpec> fit_fields() {
    FieldSpec frame{.key = "frame",
                    .title = "Axes of the flange",
                    .kind = FieldKind::choice,
                    .help =
                        "Measured axes are not exactly perpendicular: which one is kept as measured. A third "
                        "measured axis then only helps the sphere and the mean.",
                    .default_value = std::string("y-first"),
                    .shown_if = when_tool,
                    .section = "Fit"};
    for (const FrameRule& rule : frame_rules) frame.choices.push_back({rule.key, rule.title});
    return {
        frame,
        {.key = "sphere",
         .title = "Centre of the flange",
         .kind = FieldKind::choice,
         .help = "Sphere through all points by linear least squares, or refined to least distances from it.",
         .default_value = std::string("geometric"),
         .choices = {{"geometric", "sphere, geometric fit from the linear one"},
                     {"linear", "sphere, linear fit"}},
         .shown_if = when_tool,
         .section = "Fit"}};
}

}  // namespace

SetupSchema tcp_schema() {
    std::vector<FieldSpec> fields = measurement_fields();
    fields.push_back({.key = "flange",
                      .title = "Flange",
                      .kind = FieldKind::pose,
                      .help =
                          "Pose of the flange in the robot's frame before it turns; its origin is the centre "
                          "of the sphere on which the ball moves.",
                      .default_value = PoseValue{},
                      .shown_if = when_planned,
                      .section = "Procedure"});
    fields.push_back(tool_field("tool_x", "x"));
    fields.push_back(tool_field("tool_y", "y"));
    fields.push_back(tool_field("tool_z", "z"));
    for (FieldSpec& field : std::vector<FieldSpec>{sequences_table(), measured_table(), points_table()})
        fields.push_back(std::move(field));
    for (FieldSpec& field : fit_fields()) fields.push_back(std::move(field));
    return SetupSchema(std::move(fields));
}

}  // namespace covaria::tcp
