// The fields of "TCP from ballbars".
#include "core/kinds/ballbar/setup.h"
#include "core/kinds/points/component_evidence.h"

namespace covaria::tcp {

namespace {

const Unit mm = Unit::of("mm");
const Unit deg = Unit::of("deg");
using Rotation = StatedTcp::Rotation;
using Measured = StatedTcp::Measured;
using Place = StatedTcp::Place;
using Length = StatedTcp::Length;

const std::vector<ChoiceOf<int>> axes{{0, "x", "x"}, {1, "y", "y"}, {2, "z", "z"}};

const char* const axis_help = "Axis of the flange about which the robot turns.";

std::array<ColumnSpec, 3> coordinates() {
    return by_axis(along_axes, "Coordinate * in the frame of the ballbars.", {.unit = mm});
}

void add_measurement(Fields<StatedTcp>& fields) {
    fields.section("Measurement")
        .add(&StatedTcp::ballbars, "ballbars", "Ballbars",
             "The set of telescopic ballbars that measures the points.")
        .add(&StatedTcp::robot, "robot", "Robot",
             "Gives the repeatability with which the robot goes to the points; none: an ideal robot.",
             {.optional = true})
        .choice(&StatedTcp::task, "evaluation", "Evaluation",
                "The tool centre point from a planned procedure or from measured points; or only "
                "the points as the ballbars measure them, at given places or by measured lengths.",
                {{Task::plan, "plan", "tool centre point, planned procedure"},
                 {Task::measured, "measured", "tool centre point, measured points"},
                 {Task::points, "points", "points alone"},
                 {Task::lengths, "lengths", "points alone, measured lengths"}},
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
    fields.section("Procedure")
        .add(&StatedTcp::flange, "flange", "Flange",
             "Pose of the flange in the robot's frame before it turns; its origin is the centre "
             "of the sphere on which the ball moves.",
             {.default_value = PoseValue{}})
        .add(&StatedTcp::tool_x, tool_field("tool_x", "x"))
        .add(&StatedTcp::tool_y, tool_field("tool_y", "y"))
        .add(&StatedTcp::tool_z, tool_field("tool_z", "z"));
}

Columns<Rotation> rotation_columns() {
    return Columns<Rotation>()
        .choice(&Rotation::axis, "axis", "axis", axis_help, axes)
        .add(&Rotation::start, "start", "start", "Angle at the first point.", {.unit = deg})
        .add(&Rotation::span, "span", "span",
             "Angle from the first point to the last; negative: turned the other way.", {.unit = deg})
        .add(&Rotation::points, "points", "points",
             "Number of points, equally spaced from the first to the last.",
             {.range = {.low = 3.0, .high = 200.0}});
}

Columns<Measured> measured_columns() {
    return Columns<Measured>()
        .choice(&Measured::axis, "axis", "axis", axis_help, axes)
        .add(&Measured::angle, "angle", "angle", "Commanded angle of rotation.", {.unit = deg})
        .each(&Measured::p_B, coordinates());
}

Columns<Place> place_columns() {
    return Columns<Place>()
        .add(&Place::name, "name", "name", "Name of the point, unique.")
        .each(&Place::p_B, coordinates());
}

Columns<Length> length_columns() {
    return Columns<Length>()
        .add(&Length::point, "point", "point", "Name of the point; it has a length of every bar.")
        .add(&Length::bar, "bar", "bar", "Number of the bar, which is that of its support.",
             {.range = {.low = 1.0, .high = double(most_supports)}})
        .add(&Length::length, "length", "length", "From the support to the ball, as read.",
             {.unit = mm, .range = {.low = 0.0, .low_open = true}, .observed = true});
}

void add_points(Fields<StatedTcp>& fields) {
    fields.section("Procedure")
        .table(&StatedTcp::rotations, "sequences", "Rotations",
               "Two or three rotations of the flange about its own axes, its origin held in place: the "
               "ball traces an arc in each.",
               rotation_columns(), {.min_rows = 2})
        .table(&StatedTcp::measured, "measured_points", "Measured points",
               "Points as measured, each with the axis of its rotation and the commanded angle, "
               "typed or from a CSV file.",
               measured_columns(), {.measured = true})
        .table(&StatedTcp::places, "points", "Points",
               "Places of the ball that are measured, typed or from a CSV file.", place_columns(),
               {.min_rows = 1})
        .table(&StatedTcp::lengths, "lengths", "Lengths",
               "Lengths of the bars at each point, typed or from a CSV file. Those of more than three bars "
               "are adjusted, and their residuals tell their uncertainty.",
               length_columns(), {.min_rows = 3, .measured = true})
        .choice(&StatedTcp::uncertainties, uncertainties_key, "Uncertainties of the lengths",
                "As the ballbars state them, or as the residuals of the lengths see them.",
                choices_of_uncertainties(), evidence::UncertaintiesFrom::stated);
}

std::vector<ChoiceOf<FrameRule>> frame_choices() {
    std::vector<ChoiceOf<FrameRule>> choices;
    for (const FrameRule& rule : frame_rules) choices.push_back({rule, rule.key, rule.title});
    return choices;
}

void add_fit(Fields<StatedTcp>& fields) {
    fields.section("Fit")
        .choice(&StatedTcp::frame, "frame", "Axes of the flange",
                "Measured axes are not exactly perpendicular: which one is kept as measured. A "
                "third measured axis then only helps the sphere and the mean.",
                frame_choices(), frame_rules[0])
        .choice(&StatedTcp::geometric_sphere, "sphere", "Centre of the flange",
                "Sphere through all points by linear least squares, or refined to least distances "
                "from it.",
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
        .shown_where(&StatedTcp::task, {Task::lengths}, &StatedTcp::lengths, &StatedTcp::uncertainties)
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
