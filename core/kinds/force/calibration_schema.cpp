// Fields of a multi-axis force/moment sensor.
#include "core/kinds/force/calibration.h"
#include "core/kinds/force/force_sensor.h"

namespace covaria::force {

namespace {

const Condition readings_given{"data", {"readings"}};
const Condition summary_given{"data", {"summary"}};

Unit volt_ratio() {
    return Unit::of("mV/V");
}

ColumnSpec axis_column(const char* key, const char* help) {
    ColumnSpec column{.key = key, .title = "axis", .kind = FieldKind::choice, .help = help};
    for (const ForceAxis& axis : force_axes) column.choices.push_back({axis.key, axis.key});
    return column;
}

/// A column for each axis; cells of axes that the sensor does not have stay empty.
void add_axis_columns(FieldSpec& table, const Unit& unit, const std::string& help) {
    for (const ForceAxis& axis : force_axes)
        table.columns.push_back(
            {.key = axis.key, .title = axis.key, .unit = unit, .optional = true, .help = help});
}

std::vector<FieldSpec> sensor_fields() {
    const char* const section = "Sensor";
    FieldSpec channels{.key = "channels",
                       .title = "Channels",
                       .kind = FieldKind::table,
                       .help = "The forces and moments that the sensor measures, with their rated loads.",
                       .min_rows = 1,
                       .section = section};
    channels.columns = {axis_column("axis", "Force or moment that the channel measures."),
                        {.key = "rated_force",
                         .title = "rated force",
                         .unit = Unit::of("N"),
                         .range = {.low = 0.0, .low_open = true},
                         .optional = true,
                         .help = "Rated load of Fx, Fy or Fz."},
                        {.key = "rated_moment",
                         .title = "rated moment",
                         .unit = Unit::of("N*m"),
                         .range = {.low = 0.0, .low_open = true},
                         .optional = true,
                         .help = "Rated load of Mx, My or Mz."}};
    const auto length = [&](const char* key, const char* title, double mm) {
        return FieldSpec{.key = key,
                         .title = title,
                         .help = "Of its housing, for the picture.",
                         .unit = Unit::of("mm"),
                         .range = {.low = 0.0, .low_open = true},
                         .default_value = Quantity{mm, Unit::of("mm")},
                         .section = section};
    };
    return {channels,
            {.key = "placement",
             .title = "Place",
             .kind = FieldKind::pose,
             .help = "Where the sensor's axes are; loads are along and about them.",
             .default_value = PoseValue{},
             .section = section},
            length("diameter", "Diameter", 80.0),
            length("height", "Height", 40.0),
            {.key = "resolution",
             .title = "Resolution of the indicator",
             .help = "Smallest step of the indicated value, r of Eq 6.",
             .unit = volt_ratio(),
             .range = {.low = 0.0},
             .section = "Indicator"},
            {.key = "range",
             .title = "Range of the indicator",
             .help = "Largest value that it can indicate; a reading there is refused as saturated. Empty: "
                     "only readings that stand still while the load rises are.",
             .unit = volt_ratio(),
             .range = {.low = 0.0, .low_open = true},
             .optional = true,
             .section = "Indicator"}};
}

std::vector<FieldSpec> plan_fields() {
    const char* const section = "Calibration plan";
    const auto count = [&](const char* key, const char* title, double value, const char* help) {
        return FieldSpec{.key = key,
                         .title = title,
                         .kind = FieldKind::integer,
                         .help = help,
                         .range = {.low = 0.0, .high = 1000.0},
                         .default_value = Quantity{value, Unit()},
                         .section = section};
    };
    const auto time = [&](const char* key, const char* title, double value, const char* help) {
        return FieldSpec{.key = key,
                         .title = title,
                         .help = help,
                         .unit = Unit::of("s"),
                         .range = {.low = 0.0},
                         .default_value = Quantity{value, Unit::of("s")},
                         .section = section};
    };
    return {count("preloads", "Preloads", 3.0, "How often each axis is loaded to its rated load before."),
            count("runs", "Runs", 3.0, "Calibration series of each axis: n of Eqs 2 to 4."),
            count("steps", "Steps", 5.0,
                  "Loads of a series up to the rated load; the paper asks for five or more."),
            {.key = "decreasing",
             .title = "Decreasing loads too",
             .kind = FieldKind::flag,
             .help = "Whether each series goes down again; hysteresis needs it.",
             .default_value = true,
             .section = section},
            time("free_time", "Without load before a series", 120.0, "Before each series, Fig. 2."),
            time("load_time", "At each load", 30.0, "Before a reading is taken, Fig. 2.")};
}

FieldSpec readings_table() {
    FieldSpec table{.key = "readings",
                    .title = "Readings",
                    .kind = FieldKind::table,
                    .help =
                        "Indicated values of all channels at each step, the unloaded value not subtracted; "
                        "typed or from a CSV file, whose columns may have other names.",
                    .optional = true,
                    .shown_if = readings_given,
                    .section = "Calibration"};
    const auto choice = [](const char* key, std::vector<Choice> choices, const char* help) {
        return ColumnSpec{
            .key = key, .title = key, .kind = FieldKind::choice, .choices = std::move(choices), .help = help};
    };
    table.columns = {
        axis_column("loaded_axis", "Axis on which the machine's load acts."),
        choice("series", {{"preload", "preload"}, {"calibration", "calibration"}},
               "Preloading or calibration."),
        {.key = "run", .title = "run", .kind = FieldKind::integer, .help = "Number of the repetition."},
        choice("phase",
               {{"zero_before", "zero before"},
                {"load", "load"},
                {"increasing", "increasing"},
                {"decreasing", "decreasing"},
                {"zero_after", "zero after"}},
               "Unloaded before, preload, increasing or decreasing load, unloaded after."),
        {.key = "step",
         .title = "step",
         .kind = FieldKind::integer,
         .help = "Number of the step: 0 without load, the same number for increasing and decreasing load."},
        {.key = "load", .title = "load", .help = "Load in the unit of the next column."},
        {.key = "load_unit",
         .title = "load unit",
         .kind = FieldKind::text,
         .optional = true,
         .help = "N, kN, Nm ...; empty: N for forces and N·m for moments."},
        {.key = "t", .title = "t", .unit = Unit::of("s"), .optional = true, .help = "Time of the reading."}};
    add_axis_columns(table, volt_ratio(), "Indicated value of this channel.");
    return table;
}

std::vector<FieldSpec> summary_tables() {
    const auto figure = [](const char* key, const char* title, const char* help, bool optional = false) {
        return ColumnSpec{
            .key = key, .title = title, .unit = volt_ratio(), .optional = optional, .help = help};
    };
    FieldSpec summary{.key = "summary",
                      .title = "Summary",
                      .kind = FieldKind::table,
                      .help = "What an evaluation states of each channel, like Tables 1 and 3 of the paper.",
                      .optional = true,
                      .shown_if = summary_given,
                      .section = "Calibration"};
    const auto not_negative = [](ColumnSpec column) {
        column.range = {.low = 0.0};
        return column;
    };
    summary.columns = {
        axis_column("axis", "Channel."),
        figure("rated_output", "rated output", "Mean net reading at the rated load."),
        figure("zero_error", "non-zero error",
               "Non-zero error: change of the unloaded reading over a series."),
        not_negative(
            figure("u_A", "u_A", "Type A standard uncertainty of the mean, the largest of all steps.")),
        figure("hysteresis", "hysteresis", "Largest difference between increasing and decreasing load."),
        not_negative(figure("u_B", "u_B",
                            "Type B standard uncertainty as stated; empty: from the machine, the "
                            "resolution and the non-zero error (Eq 8).",
                            true))};
    FieldSpec interference{.key = "interference",
                           .title = "Interference",
                           .kind = FieldKind::table,
                           .help =
                               "Outputs at rated loads on other axes, like Table 2 of the paper; which "
                               "index is the load is chosen below.",
                           .optional = true,
                           .shown_if = summary_given,
                           .section = "Calibration"};
    interference.columns = {axis_column("axis", "Row of the table.")};
    add_axis_columns(interference, volt_ratio(), "Column of the table; empty on the diagonal.");
    return {summary,
            interference,
            {.key = "has_signs",
             .title = "Interference has signs",
             .kind = FieldKind::flag,
             .help = "Whether the signs are printed. Without them interference cannot be compensated.",
             .default_value = false,
             .shown_if = summary_given,
             .section = "Calibration"}};
}

std::vector<FieldSpec> evaluation_fields() {
    FieldSpec stated{
        .key = "stated",
        .title = "Stated values",
        .kind = FieldKind::table,
        .help = "Values that a certificate or a paper prints, to be compared with those computed.",
        .optional = true,
        .section = "Comparison"};
    stated.columns = {axis_column("axis", "Channel.")};
    for (const auto& [key, title] : {std::pair{"rated_output", "rated output"},
                                     {"zero_error", "non-zero error"},
                                     {"u_A", "u_A"},
                                     {"u_B", "u_B"},
                                     {"hysteresis", "hysteresis"},
                                     {"interference", "interference"},
                                     {"u_c", "u_c"},
                                     {"U", "U"}})
        stated.columns.push_back({.key = key,
                                  .title = title,
                                  .unit = volt_ratio(),
                                  .optional = true,
                                  .help = "As printed, in mV/V; empty: not compared."});
    stated.columns.push_back({.key = "U_relative",
                              .title = "U, relative",
                              .unit = Unit::of("%"),
                              .optional = true,
                              .help = "Relative expanded uncertainty of Eq 12b."});
    stated.columns.push_back({.key = "U_load",
                              .title = "U, as a load",
                              .optional = true,
                              .help = "Expanded uncertainty of Eq 12c in N or N·m, a number without unit."});
    FieldSpec matrix{.key = "stated_interference",
                     .title = "Stated interference in %",
                     .kind = FieldKind::table,
                     .help = "Table 4 of the paper: interference by the rated output of the row.",
                     .optional = true,
                     .section = "Comparison"};
    matrix.columns = {axis_column("axis", "Row of the table.")};
    add_axis_columns(matrix, Unit::of("%"), "Column of the table; empty on the diagonal.");
    matrix.columns.push_back({.key = "largest",
                              .title = "largest",
                              .unit = Unit::of("%"),
                              .optional = true,
                              .help = "Largest of the row."});
    return {{.key = "coverage_factor",
             .title = "Coverage factor k of Eq 12",
             .help = "The paper takes 2.",
             .range = {.low = 0.0, .high = 10.0, .low_open = true},
             .default_value = Quantity{2.0, Unit()},
             .section = "Evaluation by the paper"},
            {.key = "interference_rows",
             .title = "A row of the interference table is",
             .kind = FieldKind::choice,
             .help = "Section 2.5 says e_12 is the output of Fy under Fx (row = load), but divides by the "
                     "rated output of the row and calls the row's largest the error of that sensor. Raw "
                     "readings leave no doubt; for a printed table the choice changes U.",
             .default_value = std::string("sensor"),
             .choices = {{"sensor", "a sensor: its outputs under the other loads"},
                         {"load", "a load: the outputs of the other sensors under it"}},
             .section = "Evaluation by the paper"},
            stated,
            matrix};
}

}  // namespace

SetupSchema sensor_schema() {
    std::vector<FieldSpec> fields = sensor_fields();
    fields.push_back({.key = "calibrator",
                      .title = "Calibration machine",
                      .kind = FieldKind::reference,
                      .help = "What loaded the sensor; its relative uncertainty enters by Eq 5.",
                      .capabilities = {ForceCalibratorSource::capability},
                      .section = "Calibration"});
    fields.push_back({.key = "data",
                      .title = "Data",
                      .kind = FieldKind::choice,
                      .help = "Raw readings, from which everything follows, or what an evaluation states.",
                      .default_value = std::string("readings"),
                      .choices = {{"readings", "raw readings"}, {"summary", "summary tables"}},
                      .section = "Calibration"});
    fields.push_back(readings_table());
    for (const std::vector<FieldSpec>& part : {summary_tables(), plan_fields(), evaluation_fields()})
        fields.insert(fields.end(), part.begin(), part.end());
    return SetupSchema(std::move(fields));
}

}  // namespace covaria::force
