// Rotation matrices to and from angles, rotation vectors and quaternions, as templates over the number type.
#pragma once

#include <array>

#include "core/math/dual.h"
#include "core/math/real.h"
#include "core/math/rotation_convention.h"

namespace covaria {

template <class Real>
Matrix3<Real> rotation_x(const Real& angle) {
    using namespace real_functions;
    const Real c = cos(angle), s = sin(angle), zero(0.0), one(1.0);
    Matrix3<Real> R;
    R << one, zero, zero, zero, c, -s, zero, s, c;
    return R;
}

template <class Real>
Matrix3<Real> rotation_y(const Real& angle) {
    using namespace real_functions;
    const Real c = cos(angle), s = sin(angle), zero(0.0), one(1.0);
    Matrix3<Real> R;
    R << c, zero, s, zero, one, zero, -s, zero, c;
    return R;
}

template <class Real>
Matrix3<Real> rotation_z(const Real& angle) {
    using namespace real_functions;
    const Real c = cos(angle), s = sin(angle), zero(0.0), one(1.0);
    Matrix3<Real> R;
    R << c, -s, zero, s, c, zero, zero, zero, one;
    return R;
}

/// R = Rz(gamma) Ry(beta) Rx(alpha).
template <class Real>
Matrix3<Real> rotation_from_zyx(const Vector3<Real>& angles) {
    return rotation_z(angles[2]) * rotation_y(angles[1]) * rotation_x(angles[0]);
}

/// R = Rz(alpha) Ry(beta) Rz(gamma).
template <class Real>
Matrix3<Real> rotation_from_zyz(const Vector3<Real>& angles) {
    return rotation_z(angles[0]) * rotation_y(angles[1]) * rotation_z(angles[2]);
}

namespace rotation_detail {

/// Cosine and sine of the angle of a point (c, s) at the distance h from the origin; those of 0 at the
/// origin.
template <class Real>
std::array<Real, 2> direction(const Real& c, const Real& s, const Real& h) {
    using namespace real_functions;
    const auto nowhere = h == Real(0.0);
    const Real divisor = select(nowhere, Real(1.0), h);
    return {select(nowhere, Real(1.0), Real(c / divisor)), Real(s / divisor)};
}

}  // namespace rotation_detail

/// (alpha, beta, gamma) with -pi/2 <= beta <= pi/2. In gimbal lock only alpha -+ gamma is determined: gamma
/// belongs to the alpha that is returned, so that the angles lead back to R everywhere (derivatives do not
/// exist there).
template <class Real>
Vector3<Real> zyx_from_rotation(const Matrix3<Real>& R) {
    using namespace real_functions;
    const Real h = hypot(R(2, 1), R(2, 2));
    const auto [c, s] = rotation_detail::direction(R(2, 2), R(2, 1), h);
    return {Real(atan2(s, c)), Real(atan2(Real(-R(2, 0)), h)),
            Real(atan2(Real(s * R(0, 2) - c * R(0, 1)), Real(c * R(1, 1) - s * R(1, 2))))};
}

/// (alpha, beta, gamma) with 0 <= beta <= pi; in gimbal lock as above.
template <class Real>
Vector3<Real> zyz_from_rotation(const Matrix3<Real>& R) {
    using namespace real_functions;
    const Real h = hypot(R(0, 2), R(1, 2));
    const auto [c, s] = rotation_detail::direction(R(0, 2), R(1, 2), h);
    return {Real(atan2(s, c)), Real(atan2(h, R(2, 2))),
            Real(atan2(Real(c * R(1, 0) - s * R(0, 0)), Real(c * R(1, 1) - s * R(0, 1))))};
}

/// Unit quaternion (q_0, q_x, q_y, q_z) with q_0 >= 0, by the largest of its four squares (Shepperd, Journal
/// of Guidance and Control 1 (1978) 223), so that nothing is divided by a small number.
template <class Real>
std::array<Real, 4> quaternion_from_rotation(const Matrix3<Real>& R) {
    using namespace real_functions;
    const Real one(1.0);
    const std::array<Real, 4> squares{one + R(0, 0) + R(1, 1) + R(2, 2), one + R(0, 0) - R(1, 1) - R(2, 2),
                                      one - R(0, 0) + R(1, 1) - R(2, 2), one - R(0, 0) - R(1, 1) + R(2, 2)};
    const Real a = R(2, 1) - R(1, 2), b = R(0, 2) - R(2, 0), c = R(1, 0) - R(0, 1);
    const Real d = R(0, 1) + R(1, 0), e = R(0, 2) + R(2, 0), f = R(1, 2) + R(2, 1);
    const std::array<std::array<Real, 4>, 4> candidates{
        {{squares[0], a, b, c}, {a, squares[1], d, e}, {b, d, squares[2], f}, {c, e, f, squares[3]}}};
    std::array<Real, 4> q = candidates[0];
    Real largest = squares[0];
    for (std::size_t k = 1; k < 4; ++k) {
        const auto better = squares[k] > largest;
        for (std::size_t i = 0; i < 4; ++i) q[i] = select(better, candidates[k][i], q[i]);
        largest = select(better, squares[k], largest);
    }
    const Real norm = Real(2.0) * sqrt(largest);
    const Real scale = select(q[0] < Real(0.0), Real(-one / norm), Real(one / norm));
    for (Real& component : q) component = component * scale;
    return q;
}

/// Rotation of a unit quaternion.
template <class Real>
Matrix3<Real> rotation_from_quaternion(const std::array<Real, 4>& q) {
    const Real two(2.0), one(1.0);
    const Real &w = q[0], &x = q[1], &y = q[2], &z = q[3];
    Matrix3<Real> R;
    R << one - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y),  //
        two * (x * y + w * z), one - two * (x * x + z * z), two * (y * z - w * x),   //
        two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y);
    return R;
}

/// Angle times unit axis; the angle is at most pi.
template <class Real>
Vector3<Real> rotation_vector_from_rotation(const Matrix3<Real>& R) {
    using namespace real_functions;
    const std::array<Real, 4> q = quaternion_from_rotation(R);
    const Real n2 = q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    // A small angle needs 2 atan2(n, q0)/n = 2/q0 (1 - n2/(3 q0^2) ...); the other branch would divide by 0.
    const auto small = n2 < Real(1e-12);
    const Real n = sqrt(select(small, Real(1.0), n2));
    const Real series = Real(2.0) / q[0] * (Real(1.0) - n2 / (Real(3.0) * q[0] * q[0]));
    const Real factor = select(small, series, Real(Real(2.0) * atan2(n, q[0]) / n));
    return {Real(factor * q[1]), Real(factor * q[2]), Real(factor * q[3])};
}

template <class Real>
Matrix3<Real> rotation_from_vector(const Vector3<Real>& r) {
    using namespace real_functions;
    const Real angle2 = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    const auto small = angle2 < Real(1e-12);
    const Real angle = sqrt(select(small, Real(1.0), angle2));
    const Real half = Real(0.5) * angle;
    const Real factor = select(small, Real(Real(0.5) - angle2 / Real(48.0)), Real(sin(half) / angle));
    const Real q0 = select(small, Real(Real(1.0) - angle2 / Real(8.0)), Real(cos(half)));
    return rotation_from_quaternion<Real>({q0, factor * r[0], factor * r[1], factor * r[2]});
}

/// The coordinates of R in a convention: three numbers, or four of a quaternion (the fourth is 0 otherwise).
template <class Real>
std::array<Real, 4> rotation_coordinates(RotationConvention convention, const Matrix3<Real>& R) {
    if (convention == RotationConvention::quaternion) return quaternion_from_rotation(R);
    const Vector3<Real> v = convention == RotationConvention::zyx   ? zyx_from_rotation(R)
                            : convention == RotationConvention::zyz ? zyz_from_rotation(R)
                                                                    : rotation_vector_from_rotation(R);
    return {v[0], v[1], v[2], Real(0.0)};
}

}  // namespace covaria
