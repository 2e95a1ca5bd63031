// Set-up fields common to artefacts.
#include "core/kinds/points/artefact_fields.h"

#include <cmath>

namespace covaria {

namespace {

constexpr double reference_temperature = 293.15;  // 20 °C, ISO 1

Further not_negative(const char* unit, double value = 0.0) {
    return {.unit = Unit::of(unit), .range = {.low = 0.0}, .default_value = Quantity{value, Unit::of(unit)}};
}

}  // namespace

double MeasuredArtefact::expansion_at() const {
    return corrected ? 1.0 + expansion * (temperature - reference_temperature) : 1.0;
}

const Fields<MeasuredArtefact>& measured_artefact_fields() {
    using M = MeasuredArtefact;
    static const auto fields =
        Fields<M>()
            .section("Calibration")
            .add(&M::u_calibration, "u_cal", "Standard uncertainty of calibration",
                 "Largest standard uncertainty of the calibrated values, from the certificate (U divided by "
                 "its k).",
                 not_negative("mm"))
            .section("Temperature")
            .add(&M::expansion, "expansion", "Coefficient of thermal expansion",
                 "Linear expansion of the artefact's material; aluminium has about 23e-6 1/K.",
                 not_negative("1/K"))
            .choice(&M::corrected, "temperature", "Temperature of the artefact",
                    "Whether indications are corrected to 20 °C with a measured temperature. If not, the "
                    "largest deviation from 20 °C is a component of uncertainty.",
                    {{false, "not-corrected", "not corrected"}, {true, "corrected", "corrected to 20 °C"}},
                    false)
            .add(&M::deviation, "temperature_deviation",
                 "Largest deviation from 20 °C, or U of the temperature",
                 "ΔT of Eqs 3 and 6: without correction the largest absolute deviation from 20 °C, with "
                 "correction the expanded uncertainty of the measured temperature. Half-width of a "
                 "rectangular distribution.",
                 not_negative("K"))
            .add(&M::temperature, "measured_temperature", "Measured temperature",
                 "Temperature of the artefact during the measurement; indications are divided by "
                 "1 + α (T − 20 °C).",
                 not_negative("degC", 20.0))
            .shown_where(&M::corrected, {true}, &M::temperature);
    return fields;
}

const Fields<StatedBias>& bias_fields() {
    static const auto fields =
        Fields<StatedBias>()
            .section("Evaluation")
            .choice(&StatedBias::treatment, "bias", "Systematic error of indication",
                    "What becomes of the mean error b. The paper leaves it uncorrected and counts |b| as a "
                    "standard uncertainty; JCGM 100 3.2.4 asks for a correction.",
                    {{BiasTreatment::as_uncertainty, "as-uncertainty",
                      "counts as a standard uncertainty (paper)"},
                     {BiasTreatment::ignored, "ignored", "ignored"},
                     {BiasTreatment::corrected, "corrected",
                      "corrected, the uncertainty of the correction remains"}},
                    BiasTreatment::as_uncertainty)
            .add(&StatedBias::systematic_common, "systematic_common",
                 "Systematic parts are common to all points",
                 "Calibration, temperature and bias are drawn once for all points instead of independently "
                 "for each, as the paper does.",
                 {.default_value = false});
    return fields;
}

Columns<PrintedComponents> component_columns() {
    using Row = PrintedComponents;
    const Unit mm = Unit::of("mm");
    const Further part{.unit = mm, .range = {.low = 0.0}};
    return Columns<Row>()
        .add(&Row::u_cal, "u_cal", "u_cal", "Calibration.", part)
        .add(&Row::u_T, "u_T", "u_T", "Temperature.", part)
        .add(&Row::u_var, "u_var", "u_var", "Variability: standard deviation of the errors of indication.",
             part)
        .add(&Row::b, "b", "b", "Bias: mean of the errors of indication.", {.unit = mm})
        .add(&Row::n, "n", "n", "Number of observations, where it is known; gives the degrees of freedom.",
             {.range = {.low = 2.0}, .optional = true});
}

ErrorBudget PrintedComponents::budget(const std::string& coordinate) const {
    return {coordinate, u_cal, u_T, u_var, b, n ? static_cast<double>(*n) : infinity};
}

void check_correction(const std::vector<ErrorBudget>& budgets, BiasTreatment bias, const std::string& place,
                      Problems& problems) {
    if (bias != BiasTreatment::corrected) return;
    for (const ErrorBudget& b : budgets)
        if (std::isinf(b.observations))
            problems.error(place,
                           tell<"to correct the bias of coordinate %1, give the number of observations n in "
                                "its row: the uncertainty of the correction is u_var/sqrt(n)">(b.coordinate));
}

}  // namespace covaria
