// Least-squares registration of two sets of points in closed form, as a template over the number type.
#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include "core/math/rotation.h"

namespace covaria {

namespace registration_detail {

template <class Real>
using Matrix4 = std::array<std::array<Real, 4>, 4>;

/// The type of a number without its derivatives, and the number.
template <class Real>
using Plain = std::conditional_t<std::is_same_v<Real, Dual>, double, Real>;
template <class Real>
Plain<Real> plain(const Real& x) {
    if constexpr (std::is_same_v<Real, Dual>)
        return x.value();
    else
        return x;
}

/// qᵀ N q = tr(R(q)ᵀ H) for a unit quaternion q (Horn, Journal of the Optical Society of America A 4 (1987)
/// 629).
template <class Real>
Matrix4<Real> quadratic_form(const Matrix3<Real>& H) {
    const Real &xx = H(0, 0), &yy = H(1, 1), &zz = H(2, 2);
    const Real a = H(2, 1) - H(1, 2), b = H(0, 2) - H(2, 0), c = H(1, 0) - H(0, 1);
    const Real d = H(1, 0) + H(0, 1), e = H(0, 2) + H(2, 0), f = H(2, 1) + H(1, 2);
    return {{{Real(xx + yy + zz), a, b, c},
             {a, Real(xx - yy - zz), d, e},
             {b, d, Real(yy - xx - zz), f},
             {c, e, f, Real(zz - xx - yy)}}};
}

/// Turns the axes p and q so that N(p, q) becomes 0 where `active`; other lanes stay as they are.
template <class Real>
void turn_axes(std::size_t p, std::size_t q, const mask_of<Real>& active, Matrix4<Real>& N,
               Matrix4<Real>& axes) {
    using namespace real_functions;
    const Real zero(0.0), one(1.0);
    const Real off = select(active, N[p][q], zero);
    const Real half = Real(0.5) * (N[q][q] - N[p][p]);
    const Real size = abs(half) + sqrt(half * half + off * off);
    const Real signed_off = select(half < zero, Real(-off), off);
    const Real t = signed_off / select(size > zero, size, one);
    const Real c = one / sqrt(one + t * t), s = t * c;
    N[p][p] = N[p][p] - t * off;
    N[q][q] = N[q][q] + t * off;
    N[p][q] = N[q][p] = select(active, zero, N[p][q]);
    for (std::size_t r = 0; r < 4; ++r) {
        const Real v = axes[r][p], w = axes[r][q];
        axes[r][p] = c * v - s * w;
        axes[r][q] = s * v + c * w;
        if (r == p || r == q) continue;
        const Real x = N[r][p], y = N[r][q];
        N[r][p] = N[p][r] = c * x - s * y;
        N[r][q] = N[q][r] = s * x + c * y;
    }
}

/// Eigenvector of the largest eigenvalue of a symmetric matrix by cyclic Jacobi rotations, which converge for
/// every matrix (Forsythe and Henrici 1960). Each lane stops by itself, so its result does not depend on the
/// others.
template <class Real>
std::array<Real, 4> principal_axis(Matrix4<Real> N) {
    using namespace real_functions;
    constexpr int most_sweeps = 12;  // four to six are needed
    constexpr std::array<std::pair<std::size_t, std::size_t>, 6> pairs{
        {{0, 1}, {2, 3}, {0, 2}, {1, 3}, {0, 3}, {1, 2}}};
    Matrix4<Real> axes;
    Real squares(0.0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            axes[i][j] = Real(i == j ? 1.0 : 0.0);
            squares += N[i][j] * N[i][j];
        }
    const Real tolerance = Real(1e-30) * squares;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        Real off(0.0);
        for (const auto& [p, q] : pairs) off += N[p][q] * N[p][q];
        const mask_of<Real> active = off > tolerance;
        if (!any(active)) break;
        for (const auto& [p, q] : pairs) turn_axes(p, q, active, N, axes);
    }
    std::array<Real, 4> axis{axes[0][0], axes[1][0], axes[2][0], axes[3][0]};
    Real largest = N[0][0];
    for (std::size_t k = 1; k < 4; ++k) {
        const mask_of<Real> larger = N[k][k] > largest;
        for (std::size_t i = 0; i < 4; ++i) axis[i] = select(larger, axes[i][k], axis[i]);
        largest = select(larger, N[k][k], largest);
    }
    const Real norm = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2] + axis[3] * axis[3]);
    for (Real& component : axis) component = component / norm;
    return axis;
}

/// Newton's step of tr(Rᵀ H), as the vector h of a Cayley rotation R (I + [h])(I − [h])⁻¹.
template <class Real>
Vector3<Real> newton_step(const Matrix3<Real>& R, const Matrix3<Real>& H) {
    const Matrix3<Real> M = R.transpose() * H;
    const Real xy = Real(0.5) * (M(0, 1) + M(1, 0)), xz = Real(0.5) * (M(0, 2) + M(2, 0)),
               yz = Real(0.5) * (M(1, 2) + M(2, 1));
    // Hessian tr(S) I − S with S the symmetric part of M; gradient from the antisymmetric part.
    const Vector3<Real> a(Real(M(1, 1) + M(2, 2)), Real(-xy), Real(-xz));
    const Vector3<Real> b(Real(-xy), Real(M(0, 0) + M(2, 2)), Real(-yz));
    const Vector3<Real> c(Real(-xz), Real(-yz), Real(M(0, 0) + M(1, 1)));
    const Vector3<Real> g(Real(M(2, 1) - M(1, 2)), Real(M(0, 2) - M(2, 0)), Real(M(1, 0) - M(0, 1)));
    const Vector3<Real> bc = b.cross(c), ca = c.cross(a), ab = a.cross(b);
    return (bc * g[0] + ca * g[1] + ab * g[2]) * Real(Real(0.5) / a.dot(bc));
}

}  // namespace registration_detail

/// The rotation R that maximises tr(Rᵀ H), H = sum q_i l_iᵀ with q_i measured and l_i local coordinates, one
/// of them from its centroid: min sum |q_i − q̄ − R (l_i − l̄)|². The global maximum, by Horn's quaternion; one
/// Newton step about it gives a dual number the derivatives of the solution (JCGM 102 6.3) and takes off what
/// rounding left. False where the points do not determine R: rounding alone would turn it by a milliradian.
template <class Real>
mask_of<Real> registration(const Matrix3<Real>& H, Matrix3<Real>& R) {
    using namespace registration_detail;
    using namespace real_functions;
    using Value = Plain<Real>;
    Matrix3<Value> H_value;
    for (int i = 0; i < 9; ++i) H_value(i / 3, i % 3) = plain(H(i / 3, i % 3));
    const Matrix3<Value> closed = rotation_from_quaternion(principal_axis(quadratic_form(H_value)));
    Matrix3<Real> start;
    for (int i = 0; i < 9; ++i) start(i / 3, i % 3) = Real(closed(i / 3, i % 3));
    const Vector3<Real> h = newton_step(start, H);
    const Real h2 = h.dot(h), scale = Real(2.0) / (Real(1.0) + h2);
    Matrix3<Real> K;
    K << Real(0.0), -h[2], h[1], h[2], Real(0.0), -h[0], -h[1], h[0], Real(0.0);
    const Matrix3<Real> KK = K * K;
    const Matrix3<Real> step = (K + KK) * scale;
    R = start + start * step;
    return h2 < Real(0.25e-6);
}

}  // namespace covaria
