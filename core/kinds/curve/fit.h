// The least-squares polynomial through the points as given.
#pragma once

#include <optional>
#include <vector>

#include "core/kinds/curve/setup.h"
#include "core/text/table.h"

namespace covaria::curve {

/// The curve is sum_j q_j phi_j(t); everything else is linear in the q_j, and about their estimates, so that
/// neither the origin nor large terms that cancel cost digits.
struct Fit {
    Polynomials polynomials;
    std::vector<double> q;   ///< estimates
    double u_of_q = 0.0;     ///< u of each q, uncorrelated; from the residuals only
    Eigen::MatrixXd gain;    ///< [q][point] dq/dy_i; stated uncertainties without u_x only
    Eigen::MatrixXd powers;  ///< [power][q]: coefficients of powers of x - x_0
    std::vector<double> coefficients;
    Eigen::MatrixXd at_predictions;  ///< [prediction][q]
    std::vector<double> predicted;
    std::vector<double> residuals;           ///< y_i - curve(x_i)
    double sum_of_squares = 0.0;             ///< sum of the squared residuals
    double sum_of_squares_regression = 0.0;  ///< about the mean, or about zero without a constant term
    double standard_deviation = 0.0;         ///< s of the residuals
    double chi_squared = 0.0;  ///< weighted sum of squares, along x and y; of stated uncertainties only
};

/// Empty if the points do not determine the polynomial, or the iteration for uncertainties in x fails.
std::optional<Fit> fit_of(const CurveSetup& setup);

/// Places at which the curve takes the value y: all t of the polynomials, rising.
std::vector<double> places_where(const Fit& fit, double y);

/// The place that belongs to an observation, and what there is to say about the choice.
struct InversePlace {
    double t = 0.0;
    double slope = 0.0;          ///< dy/dt there
    std::vector<double> others;  ///< further places, x in SI
    bool outside = false;        ///< the place is outside of the points
};
/// Error: no place, or several between the points and no `near`.
Result<InversePlace> inverse_place(const CurveSetup& setup, const Fit& fit, const Observation& observation);

/// Tables about curve and points: residuals, s, chi-squared, analysis of variance; inverse use.
std::vector<Table> curve_evaluation(const CurveSetup& setup, const Fit& fit,
                                    const std::vector<InversePlace>& inverse);

}  // namespace covaria::curve
