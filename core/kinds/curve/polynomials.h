// Orthonormal polynomials over the points of a calibration: with them the least squares have no
// ill-conditioned normal equations, whatever the degree and wherever the origin is (Forsythe, J. SIAM 5
// (1957) 74; Brubeck, Nakatsukasa and Trefethen, SIAM Review 63 (2021) 405).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/math/real.h"

namespace covaria::curve {

inline constexpr std::size_t most_coefficients = 11;

template <class Real>
using Values = std::array<Real, most_coefficients>;

/// phi_0, phi_1, ... of t = (x - centre)/half_width: the mean over the points of weight phi_j phi_k is 1 for
/// j = k and 0 else, to rounding. phi_0 is 1, or proportional to t - t_0 if all are to be zero there.
struct Polynomials {
    std::size_t count = 0;
    double centre = 0.0, half_width = 1.0;
    std::optional<double> zero = {};  ///< t_0
    double first = 1.0;               ///< factor of phi_0
    std::array<std::array<double, most_coefficients>, most_coefficients> recurrence{};
    std::array<double, most_coefficients> factor{};

    double t_of(double x) const { return (x - centre) / half_width; }
    double x_of(double t) const { return centre + half_width * t; }

    /// phi_k(t) and its derivative for all k:
    /// phi_(k+1) = factor_k (t phi_k - sum_(j <= k) recurrence_kj phi_j).
    template <class Real>
    void at(const Real& t, Values<Real>& phi, Values<Real>& slope) const {
        phi[0] = zero ? Real(first) * (t - Real(*zero)) : Real(first);
        slope[0] = Real(zero ? first : 0.0);
        for (std::size_t k = 0; k + 1 < count; ++k) {
            Real value = t * phi[k];
            Real change = phi[k] + t * slope[k];
            for (std::size_t j = 0; j <= k; ++j) {
                value = value - Real(recurrence[k][j]) * phi[j];
                change = change - Real(recurrence[k][j]) * slope[j];
            }
            phi[k + 1] = Real(factor[k]) * value;
            slope[k + 1] = Real(factor[k]) * change;
        }
    }
};

template <class Real>
Real sum_of(const Values<Real>& weights, const Values<Real>& of, std::size_t count) {
    Real sum = weights[0] * of[0];
    for (std::size_t k = 1; k < count; ++k) sum = sum + weights[k] * of[k];
    return sum;
}

/// Polynomials by Arnoldi's process with reorthogonalisation, in extended precision. `weights` have the mean
/// 1. Empty if the points do not determine so many.
std::optional<Polynomials> orthonormal_polynomials(std::span<const double> x, std::span<const double> weights,
                                                   std::size_t count, std::optional<double> zero_at);

}  // namespace covaria::curve
