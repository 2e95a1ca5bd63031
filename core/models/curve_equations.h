// Weighted least squares of a polynomial with uncertainties in y and in x, over any number type.
#pragma once

#include <array>

#include "core/math/real.h"
#include "core/models/curve_setup.h"

namespace covaria::curve {

template <class Real>
using Coefficients = std::array<Real, most_coefficients>;

/// a_0 + a_1 t + ...
template <class Real, class T>
Real polynomial_at(const Coefficients<Real>& a, std::size_t n, const T& t) {
    Real sum = a[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) sum = sum * t + a[k];
    return sum;
}

template <class Real>
Real slope_at(const Coefficients<Real>& a, std::size_t n, const Real& t) {
    Real sum(0.0);
    for (std::size_t k = n - 1; k > 0; --k) sum = sum * t + Real(double(k)) * a[k];
    return sum;
}

/// Normal equations N a = b, solved by Cholesky's method.
template <class Real>
struct NormalEquations {
    std::array<Coefficients<Real>, most_coefficients> matrix;
    Coefficients<Real> right;
    std::size_t n;

    explicit NormalEquations(std::size_t size) : n(size) {
        for (auto& row : matrix) row.fill(Real(0.0));
        right.fill(Real(0.0));
    }

    void add(const Real& t, const Real& residual, const Real& weight) {
        Coefficients<Real> powers;
        powers[0] = Real(1.0);
        for (std::size_t k = 1; k < n; ++k) powers[k] = powers[k - 1] * t;
        for (std::size_t i = 0; i < n; ++i) {
            right[i] = right[i] + weight * powers[i] * residual;
            for (std::size_t j = 0; j <= i; ++j) matrix[i][j] = matrix[i][j] + weight * powers[i] * powers[j];
        }
    }

    Coefficients<Real> solve() {
        using namespace real_functions;
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t k = 0; k < j; ++k) matrix[j][j] = matrix[j][j] - matrix[j][k] * matrix[j][k];
            matrix[j][j] = sqrt(matrix[j][j]);
            for (std::size_t i = j + 1; i < n; ++i) {
                for (std::size_t k = 0; k < j; ++k) matrix[i][j] = matrix[i][j] - matrix[i][k] * matrix[j][k];
                matrix[i][j] = matrix[i][j] / matrix[j][j];
            }
        }
        Coefficients<Real> a = right;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < i; ++k) a[i] = a[i] - matrix[i][k] * a[k];
            a[i] = a[i] / matrix[i][i];
        }
        for (std::size_t i = n; i-- > 0;) {
            for (std::size_t k = i + 1; k < n; ++k) a[i] = a[i] - matrix[k][i] * a[k];
            a[i] = a[i] / matrix[i][i];
        }
        return a;
    }
};

/// Coefficients of powers of (x - x_0)/scale that minimise sum (y_i - P(xi_i))^2/u_y^2 + (x_i - xi_i)^2/u_x^2
/// over the coefficients and the true places xi_i: Gauss-Newton steps with the places eliminated (effective
/// variance weights). Without u_x the first step is the solution. `x(i)` and `y(i)` give the coordinates.
template <class Real, class X, class Y>
Coefficients<Real> weighted_curve(const CurveSetup& setup, X x, Y y) {
    const std::size_t n = setup.coefficients;
    const double scale = setup.scale;
    std::array<Real, most_points> place;
    for (std::size_t i = 0; i < setup.points.size(); ++i)
        place[i] = (x(i) - Real(setup.origin)) / Real(scale);
    Coefficients<Real> a;
    a.fill(Real(0.0));
    const int steps = setup.has_u_x() ? 16 : 1;
    for (int step = 0; step < steps; ++step) {
        NormalEquations<Real> normal(n);
        const auto residual = [&](std::size_t i, const Real& slope) {
            const Real t = (x(i) - Real(setup.origin)) / Real(scale);
            return y(i) - polynomial_at(a, n, place[i]) - slope * (t - place[i]);
        };
        const auto weight = [&](std::size_t i, const Real& slope) {
            const double v = setup.points[i].u_y * setup.points[i].u_y;
            const double v_t = setup.points[i].u_x * setup.points[i].u_x / (scale * scale);
            return Real(1.0) / (Real(v) + slope * slope * Real(v_t));
        };
        for (std::size_t i = 0; i < setup.points.size(); ++i) {
            const Real slope = slope_at(a, n, place[i]);
            normal.add(place[i], residual(i, slope), weight(i, slope));
        }
        const Coefficients<Real> change = normal.solve();
        for (std::size_t i = 0; i < setup.points.size() && setup.has_u_x(); ++i) {
            const Real slope = slope_at(a, n, place[i]);
            const double v_t = setup.points[i].u_x * setup.points[i].u_x / (scale * scale);
            const Real left = residual(i, slope) - polynomial_at(change, n, place[i]);
            const Real t = (x(i) - Real(setup.origin)) / Real(scale);
            place[i] = t + Real(v_t) * slope * weight(i, slope) * left;
        }
        for (std::size_t k = 0; k < n; ++k) a[k] = a[k] + change[k];
    }
    return a;
}

}  // namespace covaria::curve
