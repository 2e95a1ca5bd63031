// Set-up fields common to artefacts, and reading them.
#include "core/kinds/points/artefact_fields.h"

#include <cmath>

namespace covaria {

namespace {

constexpr double reference_temperature = 293.15;  // 20 °C, ISO 1

const Unit kelvin = Unit::of("K");

}  // namespace

Condition from_observations() {
    return {"evaluation", {"observations"}};
}

Condition from_components() {
    return {"evaluation", {"components"}};
}

void append(std::vector<FieldSpec>& fields, const std::vector<FieldSpec>& more) {
    fields.insert(fields.end(), more.begin(), more.end());
}

FieldSpec evaluation_field(const std::string& paper_table) {
    return {.key = "evaluation",
            .title = "Evaluate from",
            .kind = FieldKind::choice,
            .help =
                "Repeated measurements of the artefact, or the components of uncertainty as a report "
                "prints them (" +
                paper_table + " of the paper).",
            .default_value = std::string("observations"),
            .choices = {{"observations", "observations"}, {"components", "components of uncertainty"}},
            .section = "Evaluation"};
}

std::vector<FieldSpec> temperature_fields() {
    const Unit expansion = Unit::of("1/K");
    return {{.key = "expansion",
             .title = "Coefficient of thermal expansion",
             .help = "Linear expansion of the artefact's material; aluminium has about 23e-6 1/K.",
             .unit = expansion,
             .range = {.low = 0.0},
             .default_value = Quantity{0.0, expansion},
             .shown_if = from_observations(),
             .section = "Temperature"},
            {.key = "temperature",
             .title = "Temperature of the artefact",
             .kind = FieldKind::choice,
             .help = "Whether indications are corrected to 20 °C with a measured temperature. If not, the "
                     "largest deviation from 20 °C is a component of uncertainty.",
             .default_value = std::string("not-corrected"),
             .choices = {{"not-corrected", "not corrected"}, {"corrected", "corrected to 20 °C"}},
             .shown_if = from_observations(),
             .section = "Temperature"},
            {.key = "temperature_deviation",
             .title = "Largest deviation from 20 °C, or U of the temperature",
             .help = "ΔT of Eqs 3 and 6: without correction the largest absolute deviation from 20 °C, with "
                     "correction the expanded uncertainty of the measured temperature. Half-width of a "
                     "rectangular distribution.",
             .unit = kelvin,
             .range = {.low = 0.0},
             .default_value = Quantity{0.0, kelvin},
             .shown_if = from_observations(),
             .section = "Temperature"},
            {.key = "measured_temperature",
             .title = "Measured temperature",
             .help = "Temperature of the artefact during the measurement; indications are divided by "
                     "1 + α (T − 20 °C).",
             .unit = Unit::of("degC"),
             .range = {.low = 0.0},
             .default_value = Quantity{20.0, Unit::of("degC")},
             .shown_if = Condition{"temperature", {"corrected"}},
             .section = "Temperature"}};
}

FieldSpec calibration_field() {
    return {.key = "u_cal",
            .title = "Standard uncertainty of calibration",
            .help =
                "Largest standard uncertainty of the calibrated values, from the certificate (U divided by "
                "its k).",
            .unit = Unit::of("mm"),
            .range = {.low = 0.0},
            .default_value = Quantity{0.0, Unit::of("mm")},
            .shown_if = from_observations(),
            .section = "Calibration"};
}

std::vector<FieldSpec> bias_fields() {
    return {{.key = "bias",
             .title = "Systematic error of indication",
             .kind = FieldKind::choice,
             .help = "What becomes of the mean error b. The paper leaves it uncorrected and counts |b| as a "
                     "standard uncertainty; JCGM 100 3.2.4 asks for a correction.",
             .default_value = std::string("as-uncertainty"),
             .choices = {{"as-uncertainty", "counts as a standard uncertainty (paper)"},
                         {"ignored", "ignored"},
                         {"corrected", "corrected, the uncertainty of the correction remains"}},
             .section = "Evaluation"},
            {.key = "systematic_common",
             .title = "Systematic parts are common to all points",
             .kind = FieldKind::flag,
             .help = "Calibration, temperature and bias are drawn once for all points instead of "
                     "independently for each, as the paper does.",
             .default_value = false,
             .section = "Evaluation"}};
}

std::vector<ColumnSpec> component_columns() {
    const Unit mm = Unit::of("mm");
    const Range not_negative{.low = 0.0};
    return {{.key = "u_cal", .title = "u_cal", .unit = mm, .range = not_negative, .help = "Calibration."},
            {.key = "u_T", .title = "u_T", .unit = mm, .range = not_negative, .help = "Temperature."},
            {.key = "u_var",
             .title = "u_var",
             .unit = mm,
             .range = not_negative,
             .help = "Variability: standard deviation of the errors of indication."},
            {.key = "b", .title = "b", .unit = mm, .help = "Bias: mean of the errors of indication."},
            {.key = "n",
             .title = "n",
             .kind = FieldKind::integer,
             .range = {.low = 2.0},
             .optional = true,
             .help = "Number of observations, where it is known; gives the degrees of freedom."}};
}

ArtefactTemperature read_temperature(const SetupReader& setup) {
    ArtefactTemperature t;
    t.expansion = setup.number("expansion");
    t.deviation = setup.number("temperature_deviation");
    if (setup.text("temperature") == "corrected")
        t.expansion_at = 1.0 + t.expansion * (setup.number("measured_temperature") - reference_temperature);
    return t;
}

BiasTreatment read_bias(const SetupReader& setup) {
    const std::string key = setup.text("bias");
    if (key == "ignored") return BiasTreatment::ignored;
    return key == "corrected" ? BiasTreatment::corrected : BiasTreatment::as_uncertainty;
}

ErrorBudget read_component_row(const SetupReader& setup, std::size_t row, const std::string& coordinate) {
    ErrorBudget budget;
    budget.coordinate = coordinate;
    budget.u_calibration = setup.cell_number("components", row, "u_cal");
    budget.u_temperature = setup.cell_number("components", row, "u_T");
    budget.u_variability = setup.cell_number("components", row, "u_var");
    budget.bias = setup.cell_number("components", row, "b");
    if (!setup.cell_empty("components", row, "n"))
        budget.observations = setup.cell_number("components", row, "n");
    return budget;
}

void check_correction(const std::vector<ErrorBudget>& budgets, BiasTreatment bias, Problems& problems) {
    if (bias != BiasTreatment::corrected) return;
    for (const ErrorBudget& b : budgets)
        if (std::isinf(b.observations))
            problems.error("/components", "to correct the bias of coordinate " + b.coordinate +
                                              ", give the number of observations n in its row: the "
                                              "uncertainty of the correction is u_var/sqrt(n)");
}

}  // namespace covaria
