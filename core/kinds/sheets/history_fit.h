// The drift of an instrument by least squares, and the day on which its next calibration is due.
#pragma once

#include <optional>
#include <vector>

#include "core/kinds/sheets/history_setup.h"
#include "core/quantity/distribution.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria::sheets {

/// The line v = level + rate (t - middle); t in years since the first calibration. Level and rate are not
/// correlated, because `middle` is the mean of the dates by their weights (JCGM 100 H.3.5).
struct HistoryFit {
    double middle = 0.0;
    double level = 0.0, rate = 0.0;      ///< SI, less the reference; SI a year
    double u_level = 0.0, u_rate = 0.0;  ///< without what all values share
    double s = 0.0;                      ///< scatter of one value about the line; 0 with stated u
    double degrees_of_freedom = infinity;
    double scatter_ratio = 0.0;  ///< root of chi squared by its degrees of freedom, for stated u; 0: none
    std::vector<double> residuals = {};

    double at(double year) const { return level + rate * (year - middle); }
};
HistoryFit fit_of(const HistorySetup& setup);

/// Drift and uncertainty some years after the last calibration.
struct PredictedValue {
    double drift = 0.0, u_drift = 0.0;             ///< since the last calibration
    double value = 0.0, u = 0.0;                   ///< value with its adjustments, SI; u of it
    double half_width = 0.0, u_rectangular = 0.0;  ///< where the drift is not corrected
};
/// The drift as a component of Type B: corrected it has u_drift; not corrected it is a rectangular
/// distribution about zero with the half-width |drift| + k u_drift (JCGM 100 4.3.7, F.2.4.5).
PredictedValue predicted(const HistorySetup& setup, const HistoryFit& fit, double years_after_last);

/// The last day on which the rule is kept, at most the longest interval after the last calibration; nothing
/// without a rule. `at_once`: it is not kept on the day of the last calibration itself.
struct DueDay {
    Days day;
    bool at_once = false, by_longest = false;
};
std::optional<DueDay> due_day(const HistorySetup& setup, const HistoryFit& fit);

std::vector<Table> history_tables(const HistorySetup& setup, const HistoryFit& fit);
std::vector<PlotSpecification> history_figures(const HistorySetup& setup, const HistoryFit& fit);

}  // namespace covaria::sheets
