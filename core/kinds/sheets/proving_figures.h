// Figures of a force-proving instrument from its deflections, by ISO 376 and EURAMET cg-4: errors, relative
// standard uncertainties, curves, classes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "core/kinds/sheets/proving_setup.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria::sheets {

/// Parts of the relative standard uncertainty of a deflection, in the order of the table.
enum class ForcePart {
    machine,
    reproducibility,
    repeatability,
    resolution,
    creep,
    zero,
    temperature,
    interpolation,
    reversibility,
    count
};
inline constexpr std::size_t force_parts = std::size_t(ForcePart::count);

/// A step; errors and uncertainties are relative to the deflection.
struct StepFigures {
    double mean = 0.0;                               ///< mean deflection of the rotations, V/V
    double fitted = 0.0;                             ///< of the interpolation
    double b = 0.0;                                  ///< (largest - smallest)/mean of X1, X3, X5
    double b_same = 0.0;                             ///< |X2 - X1| over their mean
    double f_c = 0.0;                                ///< (mean - fitted)/fitted
    std::optional<double> v;                         ///< mean of |X4' - X3|/|X3| and |X6' - X5|/|X5|
    std::array<double, 2> turned{};                  ///< contrasts of the rotations over sqrt 6: V/V
    std::array<double, force_parts> parts{};         ///< standard uncertainties
    std::vector<bool> is_of_class = {};              ///< whether it is within the limits of each class
    std::optional<std::size_t> first_class() const;  ///< index of the first class that it is of

    double part(ForcePart part) const { return parts[std::size_t(part)]; }
    double combined() const;
};

struct ProvingFigures {
    std::vector<StepFigures> steps;
    std::optional<double> f_0, c;       ///< the largest zero error of a series, with its sign; creep error
    Eigen::MatrixXd gain;               ///< [coefficient][step] of the coefficients of (F/F_N)^k
    Eigen::VectorXd coefficients;       ///< V/V
    double s_fit = 0.0;                 ///< standard deviation of the residuals, V/V
    Eigen::VectorXd uncertainty_curve;  ///< coefficients of W over (F/F_N)^k
    double raised = 0.0;                ///< what the curve of W was raised by to lie below no step
};

ProvingFigures figures_of(const ProvingSetup& setup);
/// Sum of coefficients times powers of t, which begin at `first_power`.
double polynomial_at(const Eigen::VectorXd& coefficients, std::size_t first_power, double t);

/// "mV/V/kN^2": a unit per power of the force.
Unit per_force(const std::string& unit, const Unit& force, std::size_t power);

std::vector<Table> proving_tables(const ProvingSetup& setup, const ProvingFigures& figures);
std::vector<PlotSpecification> proving_plots(const ProvingSetup& setup, const ProvingFigures& figures);

}  // namespace covaria::sheets
