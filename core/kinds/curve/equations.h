// The iterations of a calibration curve, over any number type: uncertainties in y and in x, and inverse use.
#pragma once

#include <algorithm>

#include "core/kinds/curve/fit.h"
#include "core/math/dual.h"
#include "core/math/real.h"

namespace covaria::curve {

inline constexpr int most_steps = 80;
inline constexpr double settled_limit = 1e-11;
inline constexpr double rounding = 8e-15;

/// Says whether a step no longer matters: |change| <= limit, and for derivatives 1e-9 of the largest.
inline bool is_settled(double change, double, double limit) {
    return std::abs(change) <= limit;
}
inline mask_of<Batch> is_settled(const Batch& change, const Batch&, const Batch& limit) {
    return xsimd::abs(change) <= limit;
}
inline bool is_settled(const Dual& change, const Dual& whole, const Dual& limit) {
    double largest = 0.0, step = 0.0;
    for (std::size_t k = 0; k < Dual::size; ++k) {
        largest = std::max(largest, std::abs(whole.partials()[k]));
        step = std::max(step, std::abs(change.partials()[k]));
    }
    return std::abs(change.value()) <= limit.value() && step <= 1e-9 * largest;
}

/// Normal equations N q = b of orthonormal polynomials, so well conditioned; by Cholesky's method.
template <class Real>
struct NormalEquations {
    std::array<Values<Real>, most_coefficients> matrix;
    Values<Real> right;
    std::size_t n;

    explicit NormalEquations(std::size_t size) : n(size) {
        for (auto& row : matrix) row.fill(Real(0.0));
        right.fill(Real(0.0));
    }

    void add(const Values<Real>& phi, const Real& residual, const Real& weight) {
        for (std::size_t i = 0; i < n; ++i) {
            const Real weighted = weight * phi[i];
            right[i] = right[i] + weighted * residual;
            for (std::size_t j = 0; j <= i; ++j) matrix[i][j] = matrix[i][j] + weighted * phi[j];
        }
    }

    Values<Real> solve() {
        using namespace real_functions;
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t k = 0; k < j; ++k) matrix[j][j] = matrix[j][j] - matrix[j][k] * matrix[j][k];
            matrix[j][j] = sqrt(matrix[j][j]);
            for (std::size_t i = j + 1; i < n; ++i) {
                for (std::size_t k = 0; k < j; ++k) matrix[i][j] = matrix[i][j] - matrix[i][k] * matrix[j][k];
                matrix[i][j] = matrix[i][j] / matrix[j][j];
            }
        }
        Values<Real> q = right;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < i; ++k) q[i] = q[i] - matrix[i][k] * q[k];
            q[i] = q[i] / matrix[i][i];
        }
        for (std::size_t i = n; i-- > 0;) {
            for (std::size_t k = i + 1; k < n; ++k) q[i] = q[i] - matrix[k][i] * q[k];
            q[i] = q[i] / matrix[i][i];
        }
        return q;
    }
};

/// The curve beside a point: where the point belongs, seen with its uncertainties along t and y.
template <class Real>
struct Foot {
    Values<Real> phi;
    Real residual;  ///< y - curve, taken along the tangent to the point's t
    Real weight;    ///< 1/(u_y^2 + slope^2 u_t^2)
};

/// Gauss-Newton steps for the true place of one point on a given curve.
template <class Real>
Foot<Real> foot_of(const Polynomials& polynomials, const Values<Real>& q, const Real& t, const Real& y,
                   double v_y, double v_t) {
    using namespace real_functions;
    Foot<Real> foot;
    Values<Real> slopes;
    Real place = t;
    const double limit = std::max(settled_limit * std::sqrt(v_t), rounding);
    for (int step = 0; step < most_steps; ++step) {
        polynomials.at(place, foot.phi, slopes);
        const Real slope = sum_of(q, slopes, polynomials.count);
        foot.residual = y - sum_of(q, foot.phi, polynomials.count) - slope * (t - place);
        foot.weight = Real(1.0) / (Real(v_y) + slope * slope * Real(v_t));
        if (v_t == 0.0) break;
        const Real next = t + Real(v_t) * slope * foot.weight * foot.residual;
        const Real change = next - place;
        place = next;
        if (all(is_settled(change, place, Real(limit)))) break;
    }
    return foot;
}

/// q that minimise sum (y_i - P(xi_i))^2/u_y^2 + (x_i - xi_i)^2/u_x^2 over the q and the true places xi_i:
/// Gauss-Newton steps with the places eliminated, from `q` on. `x(i)` and `y(i)` give the coordinates. False
/// where the steps have not settled.
template <class Real, class X, class Y>
mask_of<Real> fit_with_both(const CurveSetup& setup, const Polynomials& polynomials, X x, Y y,
                            Values<Real>& q) {
    using namespace real_functions;
    const std::size_t n = polynomials.count;
    const double width = polynomials.half_width;
    mask_of<Real> settled = Real(0.0) < Real(0.0);
    for (int step = 0; step < most_steps && !all(settled); ++step) {
        NormalEquations<Real> normal(n);
        for (std::size_t i = 0; i < setup.points.size(); ++i) {
            const Point& p = setup.points[i];
            const Foot<Real> foot =
                foot_of(polynomials, q, Real((x(i) - Real(polynomials.centre)) / Real(width)), Real(y(i)),
                        p.u_y * p.u_y, p.u_x * p.u_x / (width * width));
            normal.add(foot.phi, foot.residual, foot.weight);
        }
        Values<Real> root;  // 1/u(q_j)
        Real limit(settled_limit);
        for (std::size_t j = 0; j < n; ++j) {
            root[j] = sqrt(normal.matrix[j][j]);
            limit = max(limit, Real(rounding) * abs(root[j] * q[j]));
        }
        const Values<Real> change = normal.solve();
        settled = Real(0.0) == Real(0.0);
        for (std::size_t j = 0; j < n; ++j) {
            q[j] = q[j] + change[j];
            settled = settled && is_settled(Real(root[j] * change[j]), Real(root[j] * q[j]), limit);
        }
    }
    return settled;
}

/// t with curve(t) = y by Newton's method, on the branch of `start`: the slope keeps its sign. False where
/// there is none.
template <class Real>
mask_of<Real> place_of(const Polynomials& polynomials, const Values<Real>& q, const Real& y,
                       const InversePlace& start, Real& t) {
    using namespace real_functions;
    Values<Real> phi, slopes;
    t = Real(start.t);
    mask_of<Real> settled = Real(0.0) < Real(0.0);
    mask_of<Real> on_branch = Real(0.0) == Real(0.0);
    for (int step = 0; step < most_steps && !all(settled); ++step) {
        polynomials.at(t, phi, slopes);
        const Real slope = sum_of(q, slopes, polynomials.count);
        on_branch = slope * Real(start.slope) > Real(0.0);
        const Real change = (y - sum_of(q, phi, polynomials.count)) / slope;
        t = t + change;
        settled = is_settled(change, t, Real(settled_limit));
    }
    return settled && on_branch;
}

}  // namespace covaria::curve
