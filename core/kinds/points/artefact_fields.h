// Set-up fields that artefacts have in common: calibration and temperature, components, bias.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/kinds/points/error_budget.h"
#include "core/setup/fields.h"

namespace covaria {

/// `evaluation`: from observations, or from components as a report prints them in `paper_table`.
template <class S>
void add_evaluation(Fields<S>& fields, const std::string& paper_table) {
    fields.section("Evaluation")
        .choice(&S::from_observations, "evaluation", "Evaluate from",
                "Repeated measurements of the artefact, or the components of uncertainty as a report prints "
                "them (" +
                    paper_table + " of the paper).",
                {{true, "observations", "observations"}, {false, "components", "components of uncertainty"}},
                true);
}

/// Knowledge of an artefact that was measured repeatedly.
struct MeasuredArtefact {
    double u_calibration = 0.0;
    double expansion = 0.0;
    bool corrected = false;  ///< lengths are corrected to 20 °C
    double deviation = 0.0;  ///< Delta T of Eqs 3 and 6: a half-width
    double temperature = 0.0;

    /// 1 + alpha (T - 20 °C) where indications are corrected, else 1.
    double expansion_at() const;
};
const Fields<MeasuredArtefact>& measured_artefact_fields();

struct StatedBias {
    BiasTreatment treatment = BiasTreatment::as_uncertainty;
    bool systematic_common = false;
};
const Fields<StatedBias>& bias_fields();

/// A row of components as a report prints them.
struct PrintedComponents {
    double u_cal = 0.0, u_T = 0.0, u_var = 0.0, b = 0.0;
    std::optional<int> n;

    ErrorBudget budget(const std::string& coordinate) const;
};
Columns<PrintedComponents> component_columns();

/// Error at `place` if a bias is to be corrected and n is not known.
void check_correction(const std::vector<ErrorBudget>& budgets, BiasTreatment bias, const std::string& place,
                      Problems& problems);

}  // namespace covaria
