// The set-up of "calibration curve": points, polynomial, where it is used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/kinds/curve/polynomials.h"
#include "core/model/measurement_model.h"
#include "core/setup/setup_schema.h"

namespace covaria::curve {

struct Point {
    double x = 0.0, y = 0.0;  ///< SI
    double u_x = 0.0, u_y = 0.0;
};

struct Prediction {
    std::string name;
    double x = 0.0;  ///< SI
};

/// An observed y whose x is wanted.
struct Observation {
    std::string name;
    double y = 0.0, u_y = 0.0;  ///< SI
    double readings = 0.0;      ///< y is the mean of so many, which scatter as the points do; 0: not stated
    std::optional<double> near = {};
};

struct CurveSetup {
    std::vector<Point> points;
    std::vector<Prediction> predictions;
    std::vector<Observation> observations;
    std::size_t degree = 1;
    bool through_origin = false;  ///< no constant term: the curve is 0 at x_0
    double origin = 0.0;          ///< x_0
    bool from_residuals = true;
    Unit x_unit, y_unit;
    bool has_u_x() const;
    std::size_t first_power() const { return through_origin ? 1 : 0; }
    std::size_t coefficients() const { return degree + 1 - first_power(); }
    double degrees_of_freedom() const { return double(points.size()) - double(coefficients()); }
};

SetupSchema curve_schema();
std::optional<CurveSetup> read_curve_setup(const SetupReader& reader, Problems& problems);

/// Unit of the coefficient of a power: y per x^power.
Unit coefficient_unit(const CurveSetup& setup, std::size_t power);
/// A value of x or y with its unit, for people.
std::string place_text(const Unit& unit, double si);

}  // namespace covaria::curve
