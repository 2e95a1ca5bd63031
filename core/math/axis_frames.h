// Frames and parameters of an arm from its joint axes (Wen et al., 2.1.3 and 2.1.4, corrected), as a template
// over the number type.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/math/joint_transform.h"

namespace covaria {

template <class Real>
struct AxisLine {
    Vector3<Real> point, direction;
};

enum class AxisPair { skew, parallel, opposite };

/// Choices made once, from the estimates and the nominal arm.
struct AxisStructure {
    std::vector<bool> parallel;  ///< axis i + 1 and axis i + 2 are (nearly) parallel, one for each pair
    std::vector<bool> opposite;  ///< they point against each other: alpha is next to a half turn if parallel
    std::vector<double> side;    ///< x_i = side z_{i-1} × z_i, or along side (O_i − O_{i-1})
    double theta_1 = 0.0, d_1 = 0.0;  ///< given by definition: they place the base frame on axis 1

    AxisPair pair(std::size_t i) const {
        if (!parallel[i]) return AxisPair::skew;
        return opposite[i] ? AxisPair::opposite : AxisPair::parallel;
    }
};

template <class Real>
struct AxisFrame {
    Vector3<Real> x, y, z, o;
};

namespace axis_detail {

template <class Real>
Vector3<Real> unit(const Vector3<Real>& v) {
    using namespace real_functions;
    return v * Real(Real(1.0) / sqrt(v.dot(v)));
}

/// Foot of the common perpendicular of two lines on the second.
template <class Real>
Vector3<Real> foot(const AxisLine<Real>& a, const AxisLine<Real>& b) {
    const Vector3<Real> n = a.direction.cross(b.direction), w = a.point - b.point;
    const Real t = w.cross(a.direction).dot(n) * Real(Real(-1.0) / n.dot(n));
    return b.point + b.direction * t;
}

/// Point in which a line meets the plane through o with normal n.
template <class Real>
Vector3<Real> meets(const AxisLine<Real>& line, const Vector3<Real>& o, const Vector3<Real>& n) {
    const Vector3<Real> w = o - line.point;
    return line.point + line.direction * Real(w.dot(n) / line.direction.dot(n));
}

template <class Real>
AxisFrame<Real> skew_frame(const AxisLine<Real>& before, const AxisLine<Real>& axis, double side) {
    AxisFrame<Real> f;
    f.z = axis.direction;
    f.x = unit<Real>(before.direction.cross(axis.direction)) * Real(side);
    f.y = f.z.cross(f.x);
    f.o = foot(before, axis);
    return f;
}

/// x_i = y_i × z_i with y_i along z_i × h (the printed x_i = z_i × y_i is left-handed).
template <class Real>
AxisFrame<Real> parallel_frame(const Vector3<Real>& o, const Vector3<Real>& z, const AxisLine<Real>& axis,
                               double side) {
    AxisFrame<Real> f;
    f.z = axis.direction;
    f.o = meets(axis, o, z);
    const Vector3<Real> h = f.o - o;
    f.y = unit<Real>(f.z.cross(h)) * Real(side);
    f.x = f.y.cross(f.z);
    return f;
}

}  // namespace axis_detail

/// Frames 0 ... n − 1 of an arm with n axes in `frames`. Frame 0 is placed by theta_1 and d_1.
template <class Real>
void frames_from_axes(const AxisLine<Real>* axes, std::size_t n, const AxisStructure& structure,
                      AxisFrame<Real>* frames) {
    using namespace axis_detail;
    AxisFrame<Real>& base = frames[0];
    base.z = axes[0].direction;
    base.o = structure.parallel[0] ? axes[0].point : foot(axes[1], axes[0]);
    for (std::size_t i = 1; i < n; ++i)
        frames[i] = structure.parallel[i - 1]
                        ? parallel_frame(frames[i - 1].o, frames[i - 1].z, axes[i], structure.side[i - 1])
                        : skew_frame(axes[i - 1], axes[i], structure.side[i - 1]);
    const Vector3<Real> x1 = structure.parallel[0] ? unit<Real>(frames[1].y.cross(base.z)) : frames[1].x;
    const Vector3<Real> y1 = base.z.cross(x1);
    const Real c(std::cos(structure.theta_1)), s(std::sin(structure.theta_1));
    base.x = x1 * c - y1 * s;
    base.y = base.z.cross(base.x);
    base.o = base.o - base.z * Real(structure.d_1);
}

/// Parameters that lead from frame i − 1 to frame i by Eq 5. Parallel axes have two sets, (theta, alpha,
/// beta) and (theta + π, π − alpha, beta + π): it is the one with a small beta.
template <class Real>
JointValues<Real> parameters_between(const AxisFrame<Real>& a, const AxisFrame<Real>& b, AxisPair pair) {
    using namespace real_functions;
    JointValues<Real> v;
    const Vector3<Real> o = b.o - a.o;
    if (pair == AxisPair::opposite) {
        v.theta = atan2(Real(a.x.dot(b.y)), Real(-a.y.dot(b.y)));
        v.alpha = Real(std::numbers::pi) - asin(Real(a.z.dot(b.y)));
        v.beta = atan2(Real(a.z.dot(b.x)), Real(-a.z.dot(b.z)));
    } else if (pair == AxisPair::parallel) {
        v.theta = atan2(Real(-a.x.dot(b.y)), Real(a.y.dot(b.y)));
        v.alpha = asin(Real(a.z.dot(b.y)));
        v.beta = atan2(Real(-a.z.dot(b.x)), Real(a.z.dot(b.z)));
    } else {
        v.theta = atan2(Real(a.y.dot(b.x)), Real(a.x.dot(b.x)));
        v.alpha = atan2(Real(a.z.dot(b.y)), Real(a.z.dot(b.z)));
    }
    v.a = o.dot(a.x) * cos(v.theta) + o.dot(a.y) * sin(v.theta);
    v.d = o.dot(a.z);
    return v;
}

}  // namespace covaria
