// The equations of "force-moment loads", once for every number type.
#pragma once

#include <array>

#include "core/kinds/force/loads_setup.h"
#include "core/math/dual.h"
#include "core/math/real.h"

namespace covaria::force_loads {

template <class Real>
using Vector = std::array<Real, most_channels>;

/// L U = rows of a matrix in a fixed order: chosen once at the estimates, so that trials need no branches.
template <class Real>
class Factors {
public:
    /// `element(h, c)` for h, c < n.
    template <class Element>
    Factors(const std::vector<std::size_t>& rows, const Element& element) : rows_(rows), n_(rows.size()) {
        for (std::size_t i = 0; i < n_; ++i)
            for (std::size_t j = 0; j < n_; ++j) m_[i][j] = element(rows[i], j);
        for (std::size_t k = 0; k < n_; ++k) {
            inverse_[k] = Real(1.0) / m_[k][k];
            for (std::size_t i = k + 1; i < n_; ++i) {
                m_[i][k] *= inverse_[k];
                for (std::size_t j = k + 1; j < n_; ++j) m_[i][j] -= m_[i][k] * m_[k][j];
            }
        }
    }

    Vector<Real> solve(const Vector<Real>& b) const {
        Vector<Real> x;
        for (std::size_t i = 0; i < n_; ++i) {
            x[i] = b[rows_[i]];
            for (std::size_t j = 0; j < i; ++j) x[i] -= m_[i][j] * x[j];
        }
        for (std::size_t i = n_; i-- > 0;) {
            for (std::size_t j = i + 1; j < n_; ++j) x[i] -= m_[i][j] * x[j];
            x[i] *= inverse_[i];
        }
        return x;
    }

private:
    const std::vector<std::size_t>& rows_;
    std::size_t n_;
    std::array<std::array<Real, most_channels>, most_channels> m_;
    Vector<Real> inverse_;
};

/// Newton steps from the linear solution: quadratic terms are small, each step squares what is left.
inline constexpr int newton_steps = 4;
/// Change by the last step, by rated loads, above which the readings have no load.
inline constexpr double newton_limit = 1e-6;

/// l with A l + B l² = v from l with A l = v. `a(h, c)` and `b(h, c)` give the elements.
template <class Real, class Linear, class Quadratic>
mask_of<Real> refine(const LoadsSetup& setup, const Linear& a, const Quadratic& b, const Vector<Real>& v,
                     Vector<Real>& l) {
    using namespace real_functions;
    const std::size_t n = setup.size();
    mask_of<Real> converged(true);
    for (int step = 0; step < newton_steps; ++step) {
        const Factors<Real> slope(
            setup.rows, [&](std::size_t h, std::size_t c) { return a(h, c) + Real(2.0) * b(h, c) * l[c]; });
        Vector<Real> rest;
        for (std::size_t h = 0; h < n; ++h) {
            rest[h] = v[h];
            for (std::size_t c = 0; c < n; ++c) rest[h] -= (a(h, c) + b(h, c) * l[c]) * l[c];
        }
        const Vector<Real> change = slope.solve(rest);
        for (std::size_t c = 0; c < n; ++c) {
            l[c] += change[c];
            if (step + 1 == newton_steps) converged = converged && abs(change[c]) < Real(newton_limit);
        }
    }
    return converged;
}

}  // namespace covaria::force_loads
