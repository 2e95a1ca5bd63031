// The set-up of "calibration curve": points, polynomial, where it is used.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/evidence/as_seen.h"
#include "core/kinds/curve/polynomials.h"
#include "core/model/measurement_model.h"
#include "core/setup/fields.h"

namespace covaria::curve {

struct Point {
    double x = 0.0, y = 0.0;  ///< SI
    double u_x = 0.0, u_y = 0.0;
};

/// A row of the table of points, in the units of x and y.
struct StatedPoint {
    double x = 0.0, y = 0.0;
    std::optional<double> u_x, u_y;
};

/// Between the deviations of two coordinates: "y_1", "x_2".
struct StatedCorrelation {
    std::string first, second;
    double coefficient = 0.0;
};

/// A coordinate of a point: x_i before y_i in the covariance matrix of all.
struct Coordinate {
    bool is_y = false;
    std::size_t point = 0;
};
/// Empty: there is no such coordinate.
std::optional<Coordinate> coordinate_of(const std::string& symbol, std::size_t points);

struct Prediction {
    std::string name;
    double x = 0.0;  ///< SI
};

/// An observed y whose x is wanted.
struct Observation {
    std::string name;
    double y = 0.0, u_y = 0.0;  ///< SI
    int readings = 0;           ///< y is the mean of so many, which scatter as the points do; 0: not stated
    std::optional<double> near = {};
};

struct CurveSetup {
    std::vector<StatedPoint> stated_points;
    std::vector<Point> points;
    std::vector<StatedCorrelation> correlations;
    double common_u_x = 0.0, common_u_y = 0.0;  ///< u of a deviation of all x, of all y; SI once read
    Eigen::MatrixXd covariance;                 ///< covariance of all x, then all y; empty: uncorrelated
    std::vector<Prediction> predictions;
    std::vector<Observation> observations;
    std::size_t degree = 1;
    bool through_origin = false;  ///< no constant term: the curve is 0 at x_0
    double origin = 0.0;          ///< x_0
    bool from_residuals = true;
    evidence::UncertaintiesFrom uncertainties = evidence::UncertaintiesFrom::stated;
    evidence::TakenFactor seen_x = {}, seen_y = {};  ///< ratios of the u of `points` to those stated
    Unit x_unit, y_unit;
    bool has_u_x() const;
    bool has_covariance() const { return covariance.size() > 0; }
    std::size_t first_power() const { return through_origin ? 1 : 0; }
    std::size_t coefficients() const { return degree + 1 - first_power(); }
    double degrees_of_freedom() const { return double(points.size()) - double(coefficients()); }
};

const Fields<CurveSetup>& curve_fields();
/// Makes the covariance from what is stated of the points and between them.
void make_covariance(CurveSetup& setup);
std::optional<CurveSetup> read_curve_setup(const SetupReader& reader, const AssetLibrary& assets,
                                           Problems& problems);

/// Unit of the coefficient of a power: y per x^power.
Unit coefficient_unit(const CurveSetup& setup, std::size_t power);
/// A value of x or y with its unit, for people.
std::string place_text(const Unit& unit, double si);

}  // namespace covaria::curve
