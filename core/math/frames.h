// Frames from points by the 3-2-1 method, and checks of point sets. Least squares: registration.h.
#pragma once

#include <span>

#include "core/math/dual.h"
#include "core/math/real.h"

namespace covaria {

/// Side of the x-axis on which the third point lies, which gives z its direction.
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

}  // namespace covaria
