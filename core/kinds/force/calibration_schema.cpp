// Fields of a multi-axis force/moment sensor.
#include "core/kinds/force/calibration.h"

namespace covaria::force {

namespace {

const Unit volt_ratio = Unit::of("mV/V");
using Channel = StatedSensor::Channel;
using Reading = StatedSensor::Reading;
using Summary = StatedSensor::Summary;
using Phase = StatedSensor::Phase;

Columns<Channel> channel_columns() {
    const auto rated = [](const char* unit) {
        return Further{.unit = Unit::of(unit), .range = {.low = 0.0, .low_open = true}, .optional = true};
    };
    return Columns<Channel>()
        .choice(&Channel::axis, "axis", "axis", "Force or moment that the channel measures.", axis_choices())
        .add(&Channel::rated_force, "rated_force", "rated force", "Rated load of Fx, Fy or Fz.", rated("N"))
        .add(&Channel::rated_moment, "rated_moment", "rated moment", "Rated load of Mx, My or Mz.",
             rated("N*m"));
}

void add_sensor(Fields<StatedSensor>& fields) {
    const auto length = [](double mm) {
        return Further{.unit = Unit::of("mm"),
                       .range = {.low = 0.0, .low_open = true},
                       .default_value = Quantity{mm, Unit::of("mm")}};
    };
    const std::string of_housing = "Of its housing, for the picture.";
    fields.section("Sensor")
        .table(&StatedSensor::stated_channels, "channels", "Channels",
               "The forces and moments that the sensor measures, with their rated loads.", channel_columns(),
               {.min_rows = 1})
        .add(&StatedSensor::placement, "placement", "Place",
             "Where the sensor's axes are; loads are along and about them.", {.default_value = PoseValue{}})
        .add(&StatedSensor::diameter, "diameter", "Diameter", of_housing, length(80.0))
        .add(&StatedSensor::height, "height", "Height", of_housing, length(40.0))
        .section("Indicator")
        .add(&StatedSensor::resolution, "resolution", "Resolution of the indicator",
             "Smallest step of the indicated value, r of Eq 6.", {.unit = volt_ratio, .range = {.low = 0.0}})
        .add(&StatedSensor::range, "range", "Range of the indicator",
             "Largest value that it can indicate; a reading there is refused as saturated. Empty: "
             "only readings that stand still while the load rises are.",
             {.unit = volt_ratio, .range = {.low = 0.0, .low_open = true}, .optional = true});
}

Fields<Plan> plan_fields() {
    const auto count = [](double value) {
        return Further{.range = {.low = 0.0, .high = 1000.0}, .default_value = Quantity{value, Unit()}};
    };
    const auto time = [](double value) {
        const Unit second = Unit::of("s");
        return Further{.unit = second, .range = {.low = 0.0}, .default_value = Quantity{value, second}};
    };
    return Fields<Plan>()
        .section("Calibration plan")
        .add(&Plan::preloads, "preloads", "Preloads",
             "How often each axis is loaded to its rated load before.", count(3.0))
        .add(&Plan::runs, "runs", "Runs", "Calibration series of each axis: n of Eqs 2 to 4.", count(3.0))
        .add(&Plan::steps, "steps", "Steps",
             "Loads of a series up to the rated load; the paper asks for five or more.", count(5.0))
        .add(&Plan::decreasing, "decreasing", "Decreasing loads too",
             "Whether each series goes down again; hysteresis needs it.", {.default_value = true})
        .add(&Plan::free_time, "free_time", "Without load before a series", "Before each series, Fig. 2.",
             time(120.0))
        .add(&Plan::load_time, "load_time", "At each load", "Before a reading is taken, Fig. 2.", time(30.0));
}

Columns<Reading> reading_columns() {
    return Columns<Reading>()
        .choice(&Reading::loaded_axis, "loaded_axis", "axis", "Axis on which the machine's load acts.",
                axis_choices())
        .choice(&Reading::preload, "series", "series", "Preloading or calibration.",
                {{true, "preload", "preload"}, {false, "calibration", "calibration"}})
        .add(&Reading::run, "run", "run", "Number of the repetition.")
        .choice(&Reading::phase, "phase", "phase",
                "Unloaded before, preload, increasing or decreasing load, unloaded after.",
                {{Phase::zero_before, "zero_before", "zero before"},
                 {Phase::load, "load", "load"},
                 {Phase::increasing, "increasing", "increasing"},
                 {Phase::decreasing, "decreasing", "decreasing"},
                 {Phase::zero_after, "zero_after", "zero after"}})
        .add(&Reading::step, "step", "step",
             "Number of the step: 0 without load, the same number for increasing and "
             "decreasing load.")
        .add(&Reading::load, "load", "load", "Load in the unit of the next column.")
        .add(&Reading::load_unit, "load_unit", "load unit",
             "N, kN, Nm ...; empty: N for forces and N·m for moments.", {.optional = true})
        .add(&Reading::time, "t", "t", "Time of the reading.", {.unit = Unit::of("s"), .optional = true})
        .each(&Reading::indicated, axis_columns(volt_ratio, "Indicated value of this channel."));
}

Columns<Summary> summary_columns() {
    const Further figure{.unit = volt_ratio}, not_negative{.unit = volt_ratio, .range = {.low = 0.0}};
    Further u_B = not_negative;
    u_B.optional = true;
    return Columns<Summary>()
        .choice(&Summary::axis, "axis", "axis", "Channel.", axis_choices())
        .add(&Summary::rated_output, "rated_output", "rated output", "Mean net reading at the rated load.",
             figure)
        .add(&Summary::zero_error, "zero_error", "non-zero error",
             "Non-zero error: change of the unloaded reading over a series.", figure)
        .add(&Summary::u_A, "u_A", "u_A",
             "Type A standard uncertainty of the mean, the largest of all steps.", not_negative)
        .add(&Summary::hysteresis, "hysteresis", "hysteresis",
             "Largest difference between increasing and decreasing load.", figure)
        .add(&Summary::u_B, "u_B", "u_B",
             "Type B standard uncertainty as stated; empty: from the machine, the resolution and the "
             "non-zero error (Eq 8).",
             u_B);
}

void add_data(Fields<StatedSensor>& fields) {
    fields.section("Calibration")
        .add(&StatedSensor::calibrator, "calibrator", "Calibration machine",
             "What loaded the sensor; its relative uncertainty enters by Eq 5.")
        .choice(&StatedSensor::from_readings, "data", "Data",
                "Raw readings, from which everything follows, or what an evaluation states.",
                {{true, "readings", "raw readings"}, {false, "summary", "summary tables"}}, true)
        .table(&StatedSensor::readings, "readings", "Readings",
               "Indicated values of all channels at each step, the unloaded value not subtracted; "
               "typed or from a CSV file, whose columns may have other names.",
               reading_columns(), {.optional = true, .measured = true})
        .table(&StatedSensor::summary, "summary", "Summary",
               "What an evaluation states of each channel, like Tables 1 and 3 of the paper.",
               summary_columns(), {.optional = true, .measured = true})
        .table(&StatedSensor::interference, "interference", "Interference",
               "Outputs at rated loads on other axes, like Table 2 of the paper; which index is the "
               "load is chosen below.",
               Columns<Interference>()
                   .choice(&Interference::axis, "axis", "axis", "Row of the table.", axis_choices())
                   .each(&Interference::figures,
                         axis_columns(volt_ratio, "Column of the table; empty on the diagonal.")),
               {.optional = true, .measured = true})
        .add(&StatedSensor::has_signs, "has_signs", "Interference has signs",
             "Whether the signs are printed. Without them interference cannot be compensated.",
             {.default_value = false})
        .shown_where(&StatedSensor::from_readings, {true}, &StatedSensor::readings)
        .shown_where(&StatedSensor::from_readings, {false}, &StatedSensor::summary,
                     &StatedSensor::interference, &StatedSensor::has_signs);
}

void add_method(Fields<StatedSensor>& fields) {
    fields.section("Evaluation by the paper")
        .add(&StatedSensor::k, "coverage_factor", "Coverage factor k of Eq 12", "The paper takes 2.",
             {.range = {.low = 0.0, .high = 10.0, .low_open = true}, .default_value = Quantity{2.0, Unit()}})
        .choice(&StatedSensor::rows_are_loads, "interference_rows", "A row of the interference table is",
                "Section 2.5 says e_12 is the output of Fy under Fx (row = load), but divides by "
                "the rated output of the row and calls the row's largest the error of that sensor. "
                "Raw readings leave no doubt; for a printed table the choice changes U.",
                {{false, "sensor", "a sensor: its outputs under the other loads"},
                 {true, "load", "a load: the outputs of the other sensors under it"}},
                false);
}

/// Columns of the stated figures, in the order of Figure.
std::array<ColumnSpec, static_cast<std::size_t>(Figure::count)> stated_columns() {
    const auto printed = [](const char* key, const char* title) {
        return ColumnSpec{.key = key,
                          .title = title,
                          .unit = volt_ratio,
                          .optional = true,
                          .help = "As printed, in mV/V; empty: not compared."};
    };
    return {printed("rated_output", "rated output"),
            printed("zero_error", "non-zero error"),
            printed("u_A", "u_A"),
            printed("u_B", "u_B"),
            printed("hysteresis", "hysteresis"),
            printed("interference", "interference"),
            printed("u_c", "u_c"),
            printed("U", "U"),
            {.key = "U_relative",
             .title = "U, relative",
             .unit = Unit::of("%"),
             .optional = true,
             .help = "Relative expanded uncertainty of Eq 12b."},
            {.key = "U_load",
             .title = "U, as a load",
             .optional = true,
             .help = "Expanded uncertainty of Eq 12c in N or N·m, a number without unit."}};
}

std::array<ColumnSpec, most_channels + 1> stated_interference_columns() {
    const auto axes = axis_columns(Unit::of("%"), "Column of the table; empty on the diagonal.");
    std::array<ColumnSpec, most_channels + 1> columns;
    std::copy(axes.begin(), axes.end(), columns.begin());
    columns.back() = {.key = "largest",
                      .title = "largest",
                      .unit = Unit::of("%"),
                      .optional = true,
                      .help = "Largest of the row."};
    return columns;
}

void add_comparison(Fields<StatedSensor>& fields) {
    fields.section("Comparison")
        .table(&StatedSensor::stated, "stated", "Stated values",
               "Values that a certificate or a paper prints, to be compared with those computed.",
               Columns<StatedFigures>()
                   .choice(&StatedFigures::axis, "axis", "axis", "Channel.", axis_choices())
                   .each(&StatedFigures::figures, stated_columns()),
               {.optional = true, .measured = true})
        .table(&StatedSensor::stated_interference, "stated_interference", "Stated interference in %",
               "Table 4 of the paper: interference by the rated output of the row.",
               Columns<StatedInterference>()
                   .choice(&StatedInterference::axis, "axis", "axis", "Row of the table.", axis_choices())
                   .each(&StatedInterference::figures, stated_interference_columns()),
               {.optional = true, .measured = true});
}

}  // namespace

const Fields<StatedSensor>& sensor_fields() {
    static const auto fields = [] {
        Fields<StatedSensor> made;
        add_sensor(made);
        add_data(made);
        made.part(&StatedSensor::plan, plan_fields());
        add_method(made);
        add_comparison(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::force
