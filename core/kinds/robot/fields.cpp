#include "core/kinds/robot/fields.h"

namespace covaria {

namespace {

const Unit& unit_of(JointParameter p) {
    static const Unit mm = Unit::of("mm"), deg = Unit::of("deg");
    return is_length(p) ? mm : deg;
}

std::array<ColumnSpec, 5> parameter_columns() {
    static constexpr const char* helps[] = {
        "Joint angle where the reading is the zero reading.", "Offset along the joint's axis.",
        "Length of the common perpendicular.", "Twist about x between two axes.",
        "Twist about y, of a joint whose axis is parallel to the next: d is then 0 by "
        "definition. Empty: the axes are not parallel."};
    std::array<ColumnSpec, 5> columns;
    for (JointParameter p : joint_parameters)
        columns[index_of(p)] = {.key = symbol_of(p),
                                .title = symbol_of(p),
                                .unit = unit_of(p),
                                .optional = p == JointParameter::beta,
                                .help = helps[index_of(p)]};
    return columns;
}

/// A figure of the readings of joints that turn, or slide.
void add_figure(Columns<StatedJoint>& columns, StatedJoint::Figures StatedJoint::*figures,
                StatedJoint::Figure figure, const char* key, const char* title, const char* help) {
    const bool not_negative = figure >= StatedJoint::u_encoder;
    columns.element(figures, figure,
                    {.key = key,
                     .title = title,
                     .unit = Unit::of(figures == &StatedJoint::turning ? "deg" : "mm"),
                     .range = not_negative ? Range{.low = 0.0} : Range{},
                     .optional = true,
                     .help = help});
}

void add_turning(Columns<StatedJoint>& columns) {
    const auto add = [&](StatedJoint::Figure figure, const char* key, const char* title, const char* help) {
        add_figure(columns, &StatedJoint::turning, figure, key, title, help);
    };
    add(StatedJoint::zero, "q_zero", "q_0", "Reading of the joint at which theta holds; empty: 0.");
    columns.choice(&StatedJoint::against, "direction", "direction",
                   "Whether the joint angle grows or falls with the reading; empty: grows.",
                   {{false, "positive", "with the reading"}, {true, "negative", "against the reading"}},
                   {.optional = true});
    add(StatedJoint::low, "q_min", "q_min", "Lowest reading; empty: no limit.");
    add(StatedJoint::high, "q_max", "q_max", "Highest reading; empty: no limit.");
    add(StatedJoint::u_encoder, "u_encoder", "u_encoder",
        "Standard uncertainty of a reading by the joint's encoder, drawn anew at each pose.");
    add(StatedJoint::u_repeatability, "u_repeatability", "u_repeatability",
        "Standard uncertainty by which the joint comes back to a reading, drawn anew at each pose.");
}

void add_sliding(Columns<StatedJoint>& columns) {
    const auto add = [&](StatedJoint::Figure figure, const char* key, const char* title, const char* help) {
        add_figure(columns, &StatedJoint::sliding, figure, key, title, help);
    };
    columns.choice(&StatedJoint::slides, "type", "type",
                   "A joint that turns has readings q, which add to theta; one that slides has readings s, "
                   "which "
                   "add to d. Empty: it turns.",
                   {{false, "turning", "turns about its axis"}, {true, "sliding", "slides along its axis"}},
                   {.optional = true});
    add(StatedJoint::zero, "s_zero", "s_0", "Reading of a sliding joint at which d holds; empty: 0.");
    add(StatedJoint::low, "s_min", "s_min", "Lowest reading of a sliding joint; empty: no limit.");
    add(StatedJoint::high, "s_max", "s_max", "Highest reading of a sliding joint; empty: no limit.");
    add(StatedJoint::u_encoder, "u_s_encoder", "u_s_encoder",
        "Standard uncertainty of a reading of a sliding joint by its scale, drawn anew at each "
        "pose.");
    add(StatedJoint::u_repeatability, "u_s_repeatability", "u_s_repeatability",
        "Standard uncertainty by which a sliding joint comes back to a reading, drawn anew at "
        "each pose.");
}

Columns<StatedJoint> joint_columns() {
    Columns<StatedJoint> columns;
    columns.each(&StatedJoint::values, parameter_columns());
    add_turning(columns);
    add_sliding(columns);
    columns.add(
        &StatedJoint::moved_by, "moved_by", "moved by",
        "Number of another joint whose travel moves this one along: where joint 3 turns by what joints "
        "2 and 3 read, its 2. Empty: none.",
        {.range = {.low = 1.0, .high = double(most_joints)}, .optional = true});
    columns.add(&StatedJoint::share, "share", "share",
                "By which part of that travel it is moved along, with its sign; empty: 1.",
                {.optional = true});
    return columns;
}

std::array<ColumnSpec, 5> u_columns() {
    std::array<ColumnSpec, 5> columns;
    for (JointParameter p : joint_parameters) {
        const std::string symbol = symbol_of(p);
        columns[index_of(p)] = {
            .key = "u_" + symbol,
            .title = "u_" + symbol,
            .unit = unit_of(p),
            .range = {.low = 0.0},
            .optional = true,
            .help = "Standard uncertainty of " + symbol + " from this source; empty: none."};
    }
    return columns;
}

Columns<StatedUncertainty> uncertainty_columns() {
    using Row = StatedUncertainty;
    return Columns<Row>()
        .add(&Row::source, "source", "source",
             "Where the figures come from: repeatability, sampling, range, certificate ...")
        .add(&Row::joint, "joint", "joint",
             "Number of the joint; empty: all joints, each with a deviation of its own.",
             {.range = {.low = 1.0, .high = double(most_joints)}, .optional = true})
        .each(&Row::u, u_columns())
        .add(&Row::degrees_of_freedom, "dof", "nu",
             "Degrees of freedom of the figures; empty: infinitely many.",
             {.range = {.low = 0.0, .low_open = true}, .optional = true})
        .add(&Row::distribution,
             {.key = "distribution",
              .title = "distribution",
              .optional = true,
              .choices = {{"normal", "normal"}, {"rectangular", "rectangular"}, {"triangular", "triangular"}},
              .help = "Form of the distribution with this standard uncertainty; empty: normal."});
}

Columns<StatedCorrelation> correlation_columns() {
    using Row = StatedCorrelation;
    const char* const help = "A parameter by its symbol, such as d_3 or alpha_4.";
    return Columns<Row>()
        .add(&Row::first, "first", "first", help)
        .add(&Row::second, "second", "second", help)
        .add(&Row::coefficient, "r", "r", "Correlation coefficient.", {.range = {.low = -1.0, .high = 1.0}});
}

void add_geometry(Fields<StatedRobot>& fields) {
    using Convention = StatedRobot::Convention;
    fields.section("Geometry")
        .choice(&StatedRobot::convention, "convention", "Convention",
                "How the parameters of a row lead from one joint's frame to the next.",
                {{Convention::modified, "modified", "Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β for parallel joints"},
                 {Convention::standard, "standard", "Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg"},
                 {Convention::craig, "craig", "Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α and a before joint i"}},
                Convention::modified)
        .table(&StatedRobot::joints, "joints", "Joints",
               "One row for each joint from the base to the tool, in the chosen convention.", joint_columns(),
               {.min_rows = 1})
        .add(&StatedRobot::base, "base", "Base", "Where frame 0 of the robot stands in the world.",
             {.default_value = PoseValue{}})
        .add(&StatedRobot::tool, "tool", "Tool", "Where the tool is in the frame of the last link.",
             {.default_value = PoseValue{}});
}

Further figure(const char* unit) {
    return {.unit = Unit::of(unit), .range = {.low = 0.0}, .default_value = Quantity{0.0, Unit::of(unit)}};
}

void add_uncertainty(Fields<StatedRobot>& fields) {
    fields.section("Uncertainty")
        .table(&StatedRobot::uncertainties, "uncertainties", "Components of uncertainty",
               "Standard uncertainties of the parameters by source. A row for a joint and a "
               "source; components of one parameter combine in quadrature.",
               uncertainty_columns(), {.optional = true})
        .table(&StatedRobot::correlations, "correlations", "Correlation of the parameters",
               "Correlation coefficients from the identification; pairs left out are "
               "uncorrelated. A correlated parameter has one component.",
               correlation_columns(), {.optional = true})
        .add(&StatedRobot::u_tool_position, "u_tool_position", "Tool, position",
             "Standard uncertainty of each coordinate of the tool in the frame of the last link.",
             figure("mm"))
        .add(&StatedRobot::u_tool_angle, "u_tool_angle", "Tool, orientation",
             "Standard uncertainty of each rotation of the tool about its own axes.", figure("deg"));
}

}  // namespace

std::array<ColumnSpec, most_joints> reading_columns(const std::string& letter, const Unit& unit,
                                                    const std::string& help) {
    std::array<ColumnSpec, most_joints> columns;
    for (std::size_t i = 0; i < most_joints; ++i) {
        const std::string number = std::to_string(i + 1);
        columns[i] = {.key = letter + "_" + number,
                      .title = letter + "_" + number,
                      .unit = unit,
                      .optional = true,
                      .help = "Reading of joint " + number + help};
    }
    return columns;
}

const Fields<StatedRobot>& robot_fields() {
    static const auto fields = [] {
        Fields<StatedRobot> made;
        add_geometry(made);
        add_uncertainty(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria
