#include "core/kinds/robot/fields.h"

namespace covaria {

namespace {

const Unit& unit_of(JointParameter p) {
    static const Unit mm = Unit::of("mm"), deg = Unit::of("deg");
    return is_length(p) ? mm : deg;
}

FieldSpec convention_field() {
    return {.key = "convention",
            .title = "Convention",
            .kind = FieldKind::choice,
            .help = "How the parameters of a row lead from one joint's frame to the next.",
            .default_value = std::string("modified"),
            .choices = {{"modified", "Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta): beta for parallel joints"},
                        {"standard", "Rz(theta) Tz(d) Tx(a) Rx(alpha): Denavit-Hartenberg"},
                        {"craig",
                         "Rx(alpha) Tx(a) Rz(theta) Tz(d): Craig; row i holds alpha and a before "
                         "joint i"}},
            .section = "Geometry"};
}

ColumnSpec parameter_column(JointParameter p, const char* help) {
    return {.key = symbol_of(p),
            .title = symbol_of(p),
            .unit = unit_of(p),
            .optional = p == JointParameter::beta,
            .help = help};
}

ColumnSpec angle_column(const char* key, const char* title, const char* help) {
    return {.key = key, .title = title, .unit = Unit::of("deg"), .optional = true, .help = help};
}

ColumnSpec length_column(const char* key, const char* title, const char* help) {
    return {.key = key, .title = title, .unit = Unit::of("mm"), .optional = true, .help = help};
}

ColumnSpec reading_column(const char* key, const char* unit, const char* help) {
    return {.key = key,
            .title = key,
            .unit = Unit::of(unit),
            .range = {.low = 0.0},
            .optional = true,
            .help = help};
}

/// Readings of a joint that slides are lengths, so they have columns of their own.
void add_sliding_columns(FieldSpec& joints) {
    const std::vector<ColumnSpec> columns{
        {.key = "type",
         .title = "type",
         .kind = FieldKind::choice,
         .optional = true,
         .choices = {{"turning", "turns about its axis"}, {"sliding", "slides along its axis"}},
         .help =
             "A joint that turns has readings q, which add to theta; one that slides has readings s, which "
             "add to d. Empty: it turns."},
        length_column("s_zero", "s_0", "Reading of a sliding joint at which d holds; empty: 0."),
        length_column("s_min", "s_min", "Lowest reading of a sliding joint; empty: no limit."),
        length_column("s_max", "s_max", "Highest reading of a sliding joint; empty: no limit."),
        reading_column(
            "u_s_encoder", "mm",
            "Standard uncertainty of a reading of a sliding joint by its scale, drawn anew at each "
            "pose."),
        reading_column("u_s_repeatability", "mm",
                       "Standard uncertainty by which a sliding joint comes back to a reading, drawn anew at "
                       "each pose.")};
    joints.columns.insert(joints.columns.end(), columns.begin(), columns.end());
}

FieldSpec joints_field() {
    FieldSpec field{.key = "joints",
                    .title = "Joints",
                    .kind = FieldKind::table,
                    .help = "One row for each joint from the base to the tool, in the chosen convention.",
                    .min_rows = 1,
                    .section = "Geometry"};
    field.columns = {
        parameter_column(JointParameter::theta, "Joint angle where the reading is the zero reading."),
        parameter_column(JointParameter::d, "Offset along the joint's axis."),
        parameter_column(JointParameter::a, "Length of the common perpendicular."),
        parameter_column(JointParameter::alpha, "Twist about x between two axes."),
        parameter_column(JointParameter::beta,
                         "Twist about y, of a joint whose axis is parallel to the next: d is then 0 by "
                         "definition. Empty: the axes are not parallel."),
        angle_column("q_zero", "q_0", "Reading of the joint at which theta holds; empty: 0."),
        {.key = "direction",
         .title = "direction",
         .kind = FieldKind::choice,
         .optional = true,
         .choices = {{"positive", "with the reading"}, {"negative", "against the reading"}},
         .help = "Whether the joint angle grows or falls with the reading; empty: grows."},
        angle_column("q_min", "q_min", "Lowest reading; empty: no limit."),
        angle_column("q_max", "q_max", "Highest reading; empty: no limit."),
        reading_column("u_encoder", "deg",
                       "Standard uncertainty of a reading by the joint's encoder, drawn anew at each pose."),
        reading_column("u_repeatability", "deg",
                       "Standard uncertainty by which the joint comes back to a reading, drawn anew at each "
                       "pose.")};
    add_sliding_columns(field);
    return field;
}

ColumnSpec u_column(JointParameter p) {
    static std::array<std::string, 5> helps;
    std::string& help = helps[static_cast<std::size_t>(p)];
    help = std::string("Standard uncertainty of ") + symbol_of(p) + " from this source; empty: none.";
    return {.key = uncertainty_key(p),
            .title = uncertainty_key(p),
            .unit = unit_of(p),
            .range = {.low = 0.0},
            .optional = true,
            .help = help};
}

FieldSpec uncertainties_field() {
    FieldSpec field{.key = "uncertainties",
                    .title = "Components of uncertainty",
                    .kind = FieldKind::table,
                    .help =
                        "Standard uncertainties of the parameters by source. A row for a joint and a "
                        "source; components of one parameter combine in quadrature.",
                    .optional = true,
                    .section = "Uncertainty"};
    field.columns = {{.key = "source",
                      .title = "source",
                      .kind = FieldKind::text,
                      .help = "Where the figures come from: repeatability, sampling, range, certificate ..."},
                     {.key = "joint",
                      .title = "joint",
                      .kind = FieldKind::integer,
                      .range = {.low = 1.0, .high = double(most_joints)},
                      .optional = true,
                      .help = "Number of the joint; empty: all joints, each with a deviation of its own."}};
    for (JointParameter p : joint_parameters) field.columns.push_back(u_column(p));
    field.columns.push_back({.key = "dof",
                             .title = "nu",
                             .range = {.low = 0.0, .low_open = true},
                             .optional = true,
                             .help = "Degrees of freedom of the figures; empty: infinitely many."});
    field.columns.push_back(
        {.key = "distribution",
         .title = "distribution",
         .kind = FieldKind::choice,
         .optional = true,
         .choices = {{"normal", "normal"}, {"rectangular", "rectangular"}, {"triangular", "triangular"}},
         .help = "Form of the distribution with this standard uncertainty; empty: normal."});
    return field;
}

FieldSpec correlations_field() {
    FieldSpec field{.key = "correlations",
                    .title = "Correlation of the parameters",
                    .kind = FieldKind::table,
                    .help =
                        "Correlation coefficients from the identification; pairs left out are "
                        "uncorrelated. A correlated parameter has one component.",
                    .optional = true,
                    .section = "Uncertainty"};
    const auto parameter = [](const char* key) {
        return ColumnSpec{.key = key,
                          .title = key,
                          .kind = FieldKind::text,
                          .help = "A parameter by its symbol, such as d_3 or alpha_4."};
    };
    field.columns = {
        parameter("first"),
        parameter("second"),
        {.key = "r", .title = "r", .range = {.low = -1.0, .high = 1.0}, .help = "Correlation coefficient."}};
    return field;
}

FieldSpec figure(const char* key, const char* title, const char* unit, const char* help) {
    return {.key = key,
            .title = title,
            .help = help,
            .unit = Unit::of(unit),
            .range = {.low = 0.0},
            .default_value = Quantity{0.0, Unit::of(unit)},
            .section = "Uncertainty"};
}

}  // namespace

std::string uncertainty_key(JointParameter parameter) {
    return std::string("u_") + symbol_of(parameter);
}

SetupSchema robot_schema() {
    return SetupSchema({convention_field(),
                        joints_field(),
                        {.key = "base",
                         .title = "Base",
                         .kind = FieldKind::pose,
                         .help = "Where frame 0 of the robot stands in the world.",
                         .default_value = PoseValue{},
                         .section = "Geometry"},
                        {.key = "tool",
                         .title = "Tool",
                         .kind = FieldKind::pose,
                         .help = "Where the tool is in the frame of the last link.",
                         .default_value = PoseValue{},
                         .section = "Geometry"},
                        uncertainties_field(),
                        correlations_field(),
                        figure("u_tool_position", "Tool, position", "mm",
                               "Standard uncertainty of each coordinate of the tool in the frame of the last "
                               "link."),
                        figure("u_tool_angle", "Tool, orientation", "deg",
                               "Standard uncertainty of each rotation of the tool about its own axes.")});
}

}  // namespace covaria
