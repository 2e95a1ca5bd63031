// Set-up fields that artefacts have in common: material, temperature, calibration, bias.
#pragma once

#include <string>
#include <vector>

#include "core/kinds/points/error_budget.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// `evaluation`: from observations, or from components as a report prints them.
FieldSpec evaluation_field(const std::string& paper_table);
/// Material and temperature, shown when the evaluation is from observations.
std::vector<FieldSpec> temperature_fields();
FieldSpec calibration_field();
std::vector<FieldSpec> bias_fields();

/// Appends.
void append(std::vector<FieldSpec>& fields, const std::vector<FieldSpec>& more);
/// Shown when the evaluation is from observations.
Condition from_observations();
Condition from_components();
/// Columns u_cal, u_T, u_var, b, n.
std::vector<ColumnSpec> component_columns();

struct ArtefactTemperature {
    double expansion = 0.0;
    double deviation = 0.0;     ///< Delta T of Eqs 3 and 6: a half-width
    double expansion_at = 1.0;  ///< 1 + alpha (T - 20 °C) where indications are corrected, else 1
};
ArtefactTemperature read_temperature(const SetupReader& setup);
BiasTreatment read_bias(const SetupReader& setup);
/// A row of the components table; `coordinate` names it.
ErrorBudget read_component_row(const SetupReader& setup, std::size_t row, const std::string& coordinate);
/// Error if a bias is to be corrected and n is not known.
void check_correction(const std::vector<ErrorBudget>& budgets, BiasTreatment bias, Problems& problems);

}  // namespace covaria
