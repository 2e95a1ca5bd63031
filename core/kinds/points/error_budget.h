// The budget that the measurement of a calibrated artefact gives: calibration, temperature, variability, bias
// (Porath et al., Eqs 2, 3, 5, 6), shared by artefacts with points and length standards.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/kinds/points/point_uncertainty.h"
#include "core/model/asset.h"
#include "core/quantity/input_quantity.h"
#include "core/text/table.h"

namespace covaria {

enum class BiasTreatment {
    as_uncertainty,  ///< |b| counts as a standard uncertainty (the paper, after Lira and Wöger)
    ignored,
    corrected,  ///< measured values are corrected by -b; u_var/sqrt(n) of the correction remains
};

/// The budget of one coordinate: one line of Table 1 or 2. Lengths in m.
struct ErrorBudget {
    std::string coordinate;  ///< "x", "y", "z" or "L"
    double u_calibration = 0.0;
    double u_temperature = 0.0;      ///< already divided by sqrt 3
    double u_variability = 0.0;      ///< standard deviation of the errors of indication, n - 1
    double bias = 0.0;               ///< mean of the errors of indication
    double observations = infinity;  ///< n; infinite where it is not known

    /// Part of the bias in the combination, by its treatment.
    double u_bias(BiasTreatment treatment) const;
    /// Eqs 2 and 5.
    double combined(BiasTreatment treatment) const;
    /// Welch-Satterthwaite (JCGM 100 G.4): only the variability has finite degrees of freedom.
    double degrees_of_freedom(BiasTreatment treatment) const;
};

/// Mean and standard deviation of errors of indication. Error: fewer than two.
Result<ErrorBudget> budget_of_errors(const std::string& coordinate, const std::vector<double>& errors);

/// Eqs 3 and 6: L alpha dT / sqrt 3 (a rectangular distribution of half-width L alpha dT).
double temperature_uncertainty(double length, double expansion, double temperature_deviation);

/// Rule by which the budget of a coordinate becomes deviations of a measured point.
struct DeviationRule {
    BiasTreatment bias = BiasTreatment::as_uncertainty;
    bool systematic_common = false;  ///< calibration, temperature and bias are the same for all points
    double factor = 1.0;             ///< coordinate per length: 1, or 1/sqrt 2
    Message origin;                  ///< "Porath et al., Eq. 2"
};

/// Deviations along `direction`: one normal component of the combined standard uncertainty, or, with
/// `systematic_common`, the variability by itself and three common components.
std::vector<PointDeviation> deviations_of(const ErrorBudget& budget, const std::string& coordinate,
                                          const Eigen::Vector3d& direction, const DeviationRule& rule);

/// Tables 1 and 2: u_cal, u_T, u_var, b, n and u_c of each coordinate.
Table budget_table(const std::vector<ErrorBudget>& budgets, BiasTreatment treatment);

}  // namespace covaria
