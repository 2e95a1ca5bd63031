// Frames from points: the 3-2-1 method and the least-squares fit of a set of points.
#pragma once

#include <span>

#include "core/math/dual.h"
#include "core/math/real.h"

namespace covaria {

/// On which side of the x-axis the third point lies, which gives z its direction.
enum class ThirdPoint { positive_y, negative_y };

/// Axes by columns of the 3-2-1 frame (Porath et al., Eqs 9-16): x from q1 to q2; z normal to the plane of
/// the three points, z = x × (q3 − q1) for a third point at positive y and (q3 − q1) × x for one at negative
/// y; y = z × x. Not finite for coincident or collinear points.
template <class Real>
Matrix3<Real> axes_3_2_1(const Vector3<Real>& q1, const Vector3<Real>& q2, const Vector3<Real>& q3,
                         ThirdPoint side) {
    using namespace real_functions;
    const Vector3<Real> d = q2 - q1;
    const Vector3<Real> e = side == ThirdPoint::positive_y ? Vector3<Real>(q3 - q1) : Vector3<Real>(q1 - q3);
    const Vector3<Real> n = d.cross(e);
    const Vector3<Real> x = d * Real(Real(1.0) / sqrt(d.dot(d)));
    const Vector3<Real> z = n * Real(Real(1.0) / sqrt(n.dot(n)));
    Matrix3<Real> R;
    R.col(0) = x;
    R.col(1) = z.cross(x);
    R.col(2) = z;
    return R;
}

/// Sine of the angle at the first of three points: 0 if they are collinear or coincident.
double sine_of_corner(const Eigen::Vector3d& q1, const Eigen::Vector3d& q2, const Eigen::Vector3d& q3);

/// Smallest to largest extent of a set of points off a line: second singular value over the first of the
/// centred coordinates; 0 if they lie on a line or coincide.
double spread_off_a_line(std::span<const Eigen::Vector3d> points);

/// Least-squares registration, up to the solution of the rotation: maximises tr(Rᵀ H) with
/// H = sum q_i l_iᵀ (q_i measured, l_i local coordinates, both from their centroids) by Newton's method on
/// the rotation from the start R; a step is applied as a Cayley rotation, so R stays a rotation. From a start
/// within some degrees, `registration_steps` give the solution to rounding whatever the residuals are (the
/// step is quadratic in the one before). Returns whether the last step was below 1e-9 rad.
inline constexpr int registration_steps = 5;
template <class Real>
mask_of<Real> refine_registration(const Matrix3<Real>& H, Matrix3<Real>& R) {
    using namespace real_functions;
    const Real one(1.0);
    Real step2(0.0);
    for (int k = 0; k < registration_steps; ++k) {
        const Matrix3<Real> M = R.transpose() * H;
        const Real xy = Real(0.5) * (M(0, 1) + M(1, 0)), xz = Real(0.5) * (M(0, 2) + M(2, 0)),
                   yz = Real(0.5) * (M(1, 2) + M(2, 1));
        // Hessian tr(S) I - S with S the symmetric part of M; gradient from the antisymmetric part.
        const Vector3<Real> a(Real(M(1, 1) + M(2, 2)), Real(-xy), Real(-xz));
        const Vector3<Real> b(Real(-xy), Real(M(0, 0) + M(2, 2)), Real(-yz));
        const Vector3<Real> c(Real(-xz), Real(-yz), Real(M(0, 0) + M(1, 1)));
        const Vector3<Real> g(Real(M(2, 1) - M(1, 2)), Real(M(0, 2) - M(2, 0)), Real(M(1, 0) - M(0, 1)));
        const Vector3<Real> bc = b.cross(c), ca = c.cross(a), ab = a.cross(b);
        const Vector3<Real> h = (bc * g[0] + ca * g[1] + ab * g[2]) * Real(Real(0.5) / a.dot(bc));
        const Real h2 = h.dot(h), scale = Real(2.0) / (one + h2);
        Matrix3<Real> K;
        K << Real(0.0), -h[2], h[1], h[2], Real(0.0), -h[0], -h[1], h[0], Real(0.0);
        const Matrix3<Real> KK = K * K;
        const Matrix3<Real> step = (K + KK) * scale;
        R = (R + R * step).eval();
        step2 = Real(4.0) * h2;
    }
    return step2 < Real(1e-18);
}

}  // namespace covaria
