// The fields of "force-proving instrument".
#include "core/kinds/force/axis_fields.h"
#include "core/kinds/sheets/proving_setup.h"

namespace covaria::sheets {

namespace {

const Unit proving_kN = Unit::of("kN"), proving_ratio = Unit::of("mV/V"), proving_percent = Unit::of("%"),
           proving_kelvin = Unit::of("K"), percent_per_kelvin = Unit::of("%/K");

Columns<ForceStep> step_columns() {
    const Further read{.unit = proving_ratio, .observed = true};
    const Further falling{.unit = proving_ratio, .optional = true, .observed = true};
    return Columns<ForceStep>()
        .add(&ForceStep::force, "force", "force", "Of the calibration machine; its unit is that of results.",
             {.unit = proving_kN, .range = {.low = 0.0, .low_open = true}})
        .element(&ForceStep::rising, 0,
                 {.key = "X1",
                  .title = "X1",
                  .unit = read.unit,
                  .help = "First position, increasing force.",
                  .observed = true})
        .element(&ForceStep::rising, 1,
                 {.key = "X2",
                  .title = "X2",
                  .unit = read.unit,
                  .help = "The same position again.",
                  .observed = true})
        .element(&ForceStep::rising, 2,
                 {.key = "X3",
                  .title = "X3",
                  .unit = read.unit,
                  .help = "After the first rotation, increasing force.",
                  .observed = true})
        .add(&ForceStep::falling_3, "X4", "X4′",
             "The same position as X3, decreasing force; empty: not read at this force.", falling)
        .element(&ForceStep::rising, 3,
                 {.key = "X5",
                  .title = "X5",
                  .unit = read.unit,
                  .help = "After the second rotation, increasing force.",
                  .observed = true})
        .add(&ForceStep::falling_5, "X6", "X6′",
             "The same position as X5, decreasing force; empty: not read at this force.", falling)
        .add(&ForceStep::machine_U, "U_force", "U of the force",
             "Relative expanded uncertainty (k = 2) of this force; empty: that of the calibration machine.",
             {.unit = proving_percent, .range = {.low = 0.0}, .optional = true});
}

Columns<UnloadedReadings> unloaded_columns() {
    const Further read{.unit = proving_ratio, .observed = true};
    return Columns<UnloadedReadings>()
        .choice(&UnloadedReadings::series, "series", "series", "Series with increasing forces.",
                {{ProvingSeries::first, "X1", "X1"},
                 {ProvingSeries::again, "X2", "X2"},
                 {ProvingSeries::turned, "X3", "X3"},
                 {ProvingSeries::turned_again, "X5", "X5"}})
        .add(&UnloadedReadings::before, "before", "before", "Indication without load before the series.",
             read)
        .add(&UnloadedReadings::after, "after", "after",
             "Indication without load after it, or after the decreasing forces that follow upon it.", read);
}

Columns<ClassLimits> class_columns() {
    const Further limit{.unit = proving_percent, .range = {.low = 0.0}, .optional = true};
    return Columns<ClassLimits>()
        .add(&ClassLimits::name, "class", "class", "Name of the class; the strictest first.")
        .add(&ClassLimits::b, "b", "b", "Largest reproducibility error, with rotation.", limit)
        .add(&ClassLimits::b_same, "b_same", "b′", "Largest repeatability error, without rotation.", limit)
        .add(&ClassLimits::f_c, "f_c", "f_c", "Largest interpolation error, of either sign.", limit)
        .add(&ClassLimits::f_0, "f_0", "f_0", "Largest zero error, of either sign.", limit)
        .add(&ClassLimits::v, "v", "v", "Largest reversibility error.", limit)
        .add(&ClassLimits::c, "c", "c", "Largest creep error.", limit)
        .add(&ClassLimits::machine_U, "U_force", "U of the force",
             "Largest relative expanded uncertainty (k = 2) of the calibration force.", limit);
}

void add_readings(Fields<ProvingSetup>& fields) {
    fields.section("Readings")
        .table(&ProvingSetup::steps, "steps", "Forces and indications",
               "A row for each calibration force: two series in one position, one after each of two "
               "rotations; decreasing forces where they were read. Typed, pasted or from a CSV file.",
               step_columns(), {.min_rows = 3, .measured = true})
        .table(&ProvingSetup::unloaded, "unloaded", "Indications without load",
               "Before and after each series with increasing forces. Empty: the indications are deflections "
               "already, and there is no zero error.",
               unloaded_columns(), {.optional = true, .measured = true})
        .add(&ProvingSetup::resolution, "resolution", "Resolution of the indicator",
             "Smallest step of the indication, or the half range over which it fluctuates.",
             {.unit = proving_ratio, .range = {.low = 0.0}})
        .add(&ProvingSetup::creep_30, "creep_30", "Creep: indication after 30 s",
             "Without load, 30 s after the largest force was taken off (or at that force). Empty: creep was "
             "not measured.",
             {.unit = proving_ratio, .optional = true})
        .add(&ProvingSetup::creep_300, "creep_300", "Creep: indication after 300 s", "The same after 300 s.",
             {.unit = proving_ratio, .optional = true});
}

void add_conditions(Fields<ProvingSetup>& fields) {
    fields.section("Force and conditions")
        .add(&ProvingSetup::machine, "machine", "Calibration machine",
             "Its certificate gives the relative uncertainty of the force. Empty: every force has its own.",
             {.optional = true})
        .choice(&ProvingSetup::axis, "axis", "Axis of the machine",
                "Which of the loads of its certificate acts on the instrument.", axis_choices(), 2)
        .add(&ProvingSetup::temperature_coefficient, "temperature_coefficient", "Temperature coefficient",
             "Relative change of the deflection with temperature.",
             {.unit = percent_per_kelvin,
              .range = {.low = 0.0},
              .default_value = Quantity{0.0, percent_per_kelvin}})
        .add(&ProvingSetup::temperature_half_width, "temperature_half_width", "Temperature, half width",
             "The temperature of the instrument is known within plus and minus this much.",
             {.unit = proving_kelvin, .range = {.low = 0.0}, .default_value = Quantity{0.0, proving_kelvin}})
        .choice(&ProvingSetup::decreasing, "used", "Used with",
                "Whether the instrument will be used with decreasing forces too: the reversibility error is "
                "then part of its uncertainty.",
                {{false, "increasing", "increasing forces only"}, {true, "both", "decreasing forces too"}},
                false)
        .add(&ProvingSetup::reversibility_divisor, "reversibility_divisor", "Divisor of the reversibility",
             "The reversibility error divided by it is a standard uncertainty: √3 where the error is a limit "
             "that is reached, 3 where it hardly is.",
             {.range = {.low = 1.0, .high = 10.0}, .default_value = Quantity{3.0, Unit{}}})
        .shown_where(&ProvingSetup::decreasing, {true}, &ProvingSetup::reversibility_divisor);
}

void add_curves(Fields<ProvingSetup>& fields) {
    fields.section("Curves")
        .add(&ProvingSetup::degree, "degree", "Degree of the interpolation",
             "Of the polynomial of the mean deflection over the force: 1 to 3.",
             {.range = {.low = 1.0, .high = 3.0}, .default_value = Quantity{3.0, Unit{}}})
        .add(&ProvingSetup::with_constant, "constant", "Constant term",
             "Whether the polynomial may have a value without force; else it begins at zero.",
             {.default_value = true})
        .choice(
            &ProvingSetup::residual_of_largest, "interpolation", "Interpolation counts relative to",
            "What the standard deviation of the residuals is divided by. Relative to the largest "
            "deflection it is the same part at every force; relative to each one it grows where forces "
            "are small, as a residual does.",
            {{true, "largest", "the largest deflection"}, {false, "each", "the deflection at each force"}},
            true)
        .choice(&ProvingSetup::student_t, "type_a", "Type A in Monte Carlo",
                "Normal, with its degrees of freedom in the law of propagation, or a t-distribution "
                "(JCGM 101 6.4.9), which has no standard deviation with three rotations.",
                {{false, "normal", "normal"}, {true, "student-t", "scaled and shifted t"}}, false)
        .add(&ProvingSetup::k, "coverage_factor", "Coverage factor of W",
             "In the table and curve of W; results have the coverage factor of their degrees of freedom.",
             {.range = {.low = 1.0, .high = 10.0}, .default_value = Quantity{2.0, Unit{}}})
        .add(&ProvingSetup::uncertainty_degree, "uncertainty_degree", "Degree of W over the force",
             "Of the polynomial that states W between the calibration forces.",
             {.range = {.low = 0.0, .high = 3.0}, .default_value = Quantity{2.0, Unit{}}});
}

}  // namespace

const Fields<ProvingSetup>& proving_fields() {
    static const Fields<ProvingSetup> fields = [] {
        Fields<ProvingSetup> made;
        add_readings(made);
        add_conditions(made);
        add_curves(made);
        made.section("Classes").table(
            &ProvingSetup::classes, "classes", "Limits of the classes",
            "A row for each class, the strictest first, with the largest errors that its standard allows: "
            "none of a standard is built in. An empty cell is held against nothing; without rows no class "
            "is found.",
            class_columns(), {.optional = true});
        return made;
    }();
    return fields;
}

}  // namespace covaria::sheets
