// The set-up of "calibration curve": points, polynomial, where it is used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/measurement_model.h"
#include "core/model/setup_schema.h"

namespace covaria::curve {

inline constexpr std::size_t most_points = 400;
inline constexpr std::size_t most_coefficients = 6;

struct Point {
    double x = 0.0, y = 0.0;  ///< SI
    double u_x = 0.0, u_y = 0.0;
};

struct Prediction {
    std::string name;
    double x = 0.0;  ///< SI
};

struct CurveSetup {
    std::vector<Point> points;
    std::vector<Prediction> predictions;
    std::size_t coefficients = 2;
    double origin = 0.0;  ///< x_0
    double scale = 1.0;   ///< largest |x - x_0|: powers are of (x - x_0)/scale while they are computed
    bool from_residuals = true;
    Unit x_unit, y_unit;
    bool has_u_x() const;
    double degrees_of_freedom() const { return double(points.size()) - double(coefficients); }
};

SetupSchema curve_schema();
std::optional<CurveSetup> read_curve_setup(const SetupReader& reader, Problems& problems);

/// Least squares at the points as given (JCGM 100 H.3).
struct Fit {
    Eigen::VectorXd coefficients;  ///< of powers of x - x_0, SI
    Eigen::MatrixXd covariance;
    std::vector<double> residuals;    ///< y_i - curve(x_i)
    double standard_deviation = 0.0;  ///< s of the residuals
    double chi_squared = 0.0;         ///< weighted sum of squares; of stated uncertainties only
};
Fit fit_of(const CurveSetup& setup);

/// Unit of coefficient k: y per x^k.
Unit coefficient_unit(const CurveSetup& setup, std::size_t k);
/// What the curve says about the points: residuals, s, chi-squared.
std::vector<DataTable> curve_evaluation(const CurveSetup& setup, const Fit& fit);

}  // namespace covaria::curve
