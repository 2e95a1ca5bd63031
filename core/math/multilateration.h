// Positions from lengths: the frame of three supports, trilateration, and its refinement by more lengths.
#pragma once

#include <span>

#include "core/math/dual.h"
#include "core/math/real.h"

namespace covaria {

/// Supports 1, 2 and 3 in their own frame: (0, 0, 0), (x2, 0, 0), (x3, y3, 0).
template <class Real>
struct SupportTriangle {
    Real x2, x3, y3;
};

/// Brosed et al., Eqs 4 to 7, with the sine of Eq 6 from the cosine. Not finite where the lengths violate the
/// triangle inequality.
template <class Real>
SupportTriangle<Real> support_triangle(const Real& L12, const Real& L13, const Real& L23) {
    using namespace real_functions;
    const Real cosine = (L12 * L12 + L13 * L13 - L23 * L23) / (Real(2.0) * L12 * L13);
    return {L12, L13 * cosine, L13 * sqrt(Real(Real(1.0) - cosine * cosine))};
}

/// Trilateration by one triangle of supports: what Eqs 1 and 2 need of it, once for many points.
template <class Real>
class Trilateration {
public:
    explicit Trilateration(const SupportTriangle<Real>& s)
        : by_x2_(Real(0.5) / s.x2), by_y3_(Real(0.5) / s.y3), skew_(s.x3 / s.y3) {
        x2_squared_ = s.x2 * s.x2;
        r3_squared_ = s.x3 * s.x3 + s.y3 * s.y3;
    }
    /// X and Y of a point at the lengths L1, L2, L3 from the supports, z left 0 (Brosed et al., Eqs 1 and 2,
    /// Y_VC3 read as Y_KS3).
    Vector3<Real> level(const Real& L1_squared, const Real& L2_squared, const Real& L3_squared) const {
        const Real x = (L1_squared - L2_squared + x2_squared_) * by_x2_;
        const Real y = (L1_squared - L3_squared + r3_squared_) * by_y3_ - skew_ * x;
        return {x, y, Real(0.0)};
    }
    /// Finds all three coordinates (Eqs 1 to 3) on the side of the plane that `side` names (1 or -1); false
    /// where the lengths do not meet: the root of Eq 3 is negative.
    mask_of<Real> locate(const Real* lengths, double side, Vector3<Real>& p) const {
        using namespace real_functions;
        const Real L1_squared = lengths[0] * lengths[0];
        p = level(L1_squared, lengths[1] * lengths[1], lengths[2] * lengths[2]);
        const Real z_squared = L1_squared - p[0] * p[0] - p[1] * p[1];
        const auto meets = z_squared > Real(0.0);
        p[2] = Real(side) * sqrt(select(meets, z_squared, Real(1.0)));
        return meets;
    }

private:
    Real by_x2_, by_y3_, skew_, x2_squared_, r3_squared_;
};

/// Solution of N p = g for a symmetric N, by cofactors; not finite where N is singular.
template <class Real>
Vector3<Real> solved_symmetric(const Matrix3<Real>& N, const Vector3<Real>& g) {
    const Real c00 = N(1, 1) * N(2, 2) - N(1, 2) * N(1, 2), c01 = N(0, 2) * N(1, 2) - N(0, 1) * N(2, 2),
               c02 = N(0, 1) * N(1, 2) - N(0, 2) * N(1, 1), c11 = N(0, 0) * N(2, 2) - N(0, 2) * N(0, 2),
               c12 = N(0, 1) * N(0, 2) - N(0, 0) * N(1, 2), c22 = N(0, 0) * N(1, 1) - N(0, 1) * N(0, 1);
    const Real inverse = Real(1.0) / (N(0, 0) * c00 + N(0, 1) * c01 + N(0, 2) * c02);
    return {Real((c00 * g[0] + c01 * g[1] + c02 * g[2]) * inverse),
            Real((c01 * g[0] + c11 * g[1] + c12 * g[2]) * inverse),
            Real((c02 * g[0] + c12 * g[1] + c22 * g[2]) * inverse)};
}

/// Least squares of more than three lengths: this many Gauss-Newton steps from trilateration. The error of a
/// step is in proportion to the residuals over the lengths (1e-5), so three leave rounding.
inline constexpr int multilateration_steps = 3;

/// Does one step from p on: minimises sum w (L - |p - support|)². With `free` = 2, z stays as it is.
template <class Real>
void multilateration_step(std::span<const Vector3<Real>> supports, const Real* lengths, const double* weights,
                          int free, Vector3<Real>& p) {
    using namespace real_functions;
    Matrix3<Real> N = Matrix3<Real>::Zero();
    Vector3<Real> g = Vector3<Real>::Zero();
    for (std::size_t j = 0; j < supports.size(); ++j) {
        const Vector3<Real> d = p - supports[j];
        const Real r = sqrt(Real(d.dot(d)));
        const Vector3<Real> a = d * Real(Real(1.0) / r);
        const Real w(weights[j]), residual = w * (lengths[j] - r);
        for (int row = 0; row < free; ++row) {
            for (int column = row; column < free; ++column) N(row, column) += w * a[row] * a[column];
            g[row] += a[row] * residual;
        }
    }
    if (free == 2) N(2, 2) = Real(1.0);
    p += solved_symmetric(N, g);
}

}  // namespace covaria
