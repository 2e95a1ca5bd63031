// A circle through points in space: plane by total least squares, circle by projection (geometric fit), as a
// template over the number type, near a start.
#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "core/math/dual.h"
#include "core/math/real.h"

namespace covaria {

/// A circle in space. Columns of `axes`: two directions in its plane, then its normal.
struct CircleStart {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    double radius = 0.0;
};

template <class Real>
struct SpaceCircle {
    Vector3<Real> centre, normal;
    Real radius;
    mask_of<Real> converged;
};

enum class PlaneFit {
    total_least_squares,  ///< n·p = D with |n| = 1, any plane
    equation_1,  ///< A x + B y + C z + 1 = 0 (Wen et al., Eqs 1-3): not for planes through the origin
};

namespace circle_detail {

inline constexpr int plane_steps = 6, circle_steps = 10, dual_steps = 4;

/// Points in the axes of the start, from its centre.
template <class Real, class Points>
Vector3<Real> local(const CircleStart& start, const Points& point, std::size_t k) {
    const Vector3<Real> p = point(k);
    Vector3<Real> q;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d& e = start.axes.col(i);
        q[i] = (p[0] - Real(start.centre[0])) * Real(e[0]) + (p[1] - Real(start.centre[1])) * Real(e[1]) +
               (p[2] - Real(start.centre[2])) * Real(e[2]);
    }
    return q;
}

/// Slopes (t_u, t_v) of the normal (t_u, t_v, 1): eigenvector of the least eigenvalue of the scatter matrix
/// S.
template <class Real>
void normal_slopes(const Matrix3<Real>& S, Real& tu, Real& tv) {
    Real mu = S(2, 2);
    for (int k = 0; k < plane_steps; ++k) {
        const Real a = S(0, 0) - mu, b = S(0, 1), c = S(1, 1) - mu;
        const Real det = a * c - b * b;
        tu = (b * S(1, 2) - c * S(0, 2)) / det;
        tv = (b * S(0, 2) - a * S(1, 2)) / det;
        mu = S(2, 2) + S(0, 2) * tu + S(1, 2) * tv;
    }
}

template <class Real, class Points>
Vector3<Real> mean_of(const CircleStart& start, const Points& point, std::size_t n) {
    Vector3<Real> mean(Real(0.0), Real(0.0), Real(0.0));
    for (std::size_t k = 0; k < n; ++k) mean += local<Real>(start, point, k);
    return mean * Real(1.0 / static_cast<double>(n));
}

template <class Real, class Points>
Vector3<Real> total_normal(const CircleStart& start, const Points& point, std::size_t n,
                           const Vector3<Real>& mean) {
    Matrix3<Real> S = Matrix3<Real>::Constant(Real(0.0));
    for (std::size_t k = 0; k < n; ++k) {
        const Vector3<Real> q = local<Real>(start, point, k) - mean;
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) S(i, j) += q[i] * q[j];
    }
    Vector3<Real> normal(Real(0.0), Real(0.0), Real(1.0));
    normal_slopes(S, normal[0], normal[1]);
    return normal;
}

/// Eqs 1 to 3 in the coordinates as given, then turned into the start's axes.
template <class Real, class Points>
Vector3<Real> paper_normal(const CircleStart& start, const Points& point, std::size_t n) {
    Vector3<Real> a, b, c, s;
    a = b = c = s = Vector3<Real>(Real(0.0), Real(0.0), Real(0.0));
    for (std::size_t k = 0; k < n; ++k) {
        const Vector3<Real> p = point(k);
        a += p * p[0];
        b += p * p[1];
        c += p * p[2];
        s += p;
    }
    const Vector3<Real> X = (b.cross(c) * s[0] + c.cross(a) * s[1] + a.cross(b) * s[2]);
    Vector3<Real> normal;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d& e = start.axes.col(i);
        normal[i] = X[0] * Real(e[0]) + X[1] * Real(e[1]) + X[2] * Real(e[2]);
    }
    return normal * Real(Real(1.0) / normal[2]);
}

/// Coordinates in the fitted plane, and how they lead back to the local ones.
template <class Real>
struct Plane {
    Vector3<Real> origin, e1, e2, n;
    Plane(const Vector3<Real>& origin_, const Vector3<Real>& slopes) : origin(origin_) {
        using namespace real_functions;
        n = slopes * Real(Real(1.0) / sqrt(slopes.dot(slopes)));
        e1 = Vector3<Real>(n[2], Real(0.0), Real(-n[0]));
        e1 = (e1 * Real(Real(1.0) / sqrt(e1.dot(e1)))).eval();
        e2 = n.cross(e1);
    }
};

/// Does one Gauss-Newton step of the geometric fit: sum (|p − c| − R)² becomes least.
template <class Real, class Points>
Vector3<Real> circle_step(const CircleStart& start, const Points& point, std::size_t n,
                          const Plane<Real>& plane, const Vector3<Real>& circle) {
    using namespace real_functions;
    Real uu(0.0), uv(0.0), vv(0.0), u1(0.0), v1(0.0), gu(0.0), gv(0.0), g1(0.0);
    for (std::size_t k = 0; k < n; ++k) {
        const Vector3<Real> q = local<Real>(start, point, k) - plane.origin;
        const Real du = q.dot(plane.e1) - circle[0], dv = q.dot(plane.e2) - circle[1];
        const Real r = sqrt(Real(du * du + dv * dv)), over = Real(1.0) / r;
        const Real u = du * over, v = dv * over, miss = r - circle[2];
        uu += u * u;
        uv += u * v;
        vv += v * v;
        u1 += u;
        v1 += v;
        gu += u * miss;
        gv += v * miss;
        g1 += miss;
    }
    const Real one(static_cast<double>(n));
    const Vector3<Real> a(uu, uv, u1), b(uv, vv, v1), c(u1, v1, one);
    const Vector3<Real> bc = b.cross(c);
    return (bc * gu + c.cross(a) * gv + a.cross(b) * g1) * Real(Real(1.0) / a.dot(bc));
}

inline Eigen::Vector3d values_of(const Vector3<Dual>& v) {
    return {v[0].value(), v[1].value(), v[2].value()};
}

/// Where a fit begins, in the plane, and how many steps it takes.
template <class Real>
struct CircleBegin {
    Vector3<Real> circle;
    int steps;
};

template <class Real, class Points>
CircleBegin<Real> begin_circle(const CircleStart& start, const Points& point, std::size_t n,
                               const Plane<Real>& plane) {
    const Vector3<Real> circle(Real(-plane.origin.dot(plane.e1)), Real(-plane.origin.dot(plane.e2)),
                               Real(start.radius));
    if constexpr (!std::is_same_v<Real, Dual>)
        return {circle, circle_steps};
    else {
        // Values come to rest first, where steps cost little. Each step from there makes the partial
        // derivatives exact to a further power of the misses as parts of the radius.
        const Plane<double> values(values_of(plane.origin), values_of(plane.n));
        const auto value = [&](std::size_t k) { return values_of(point(k)); };
        Eigen::Vector3d at = values_of(circle);
        for (int k = 0; k < circle_steps; ++k) at += circle_step<double>(start, value, n, values, at);
        return {Vector3<Real>(Real(at[0]), Real(at[1]), Real(at[2])), dual_steps};
    }
}

}  // namespace circle_detail

/// `point(k)` gives a Vector3<Real> for k < n, near the start's circle. The normal is on the side of the
/// start's. Not converged where a last step is above 1e-9 of the radius.
template <class Real, class Points>
SpaceCircle<Real> fit_circle(const CircleStart& start, const Points& point, std::size_t n, PlaneFit fit) {
    using namespace circle_detail;
    using namespace real_functions;
    const Vector3<Real> mean = mean_of<Real>(start, point, n);
    const Plane<Real> plane(mean, fit == PlaneFit::equation_1 ? paper_normal<Real>(start, point, n)
                                                              : total_normal<Real>(start, point, n, mean));
    auto [circle, steps] = begin_circle<Real>(start, point, n, plane);
    Vector3<Real> step(Real(0.0), Real(0.0), Real(0.0));
    for (int k = 0; k < steps; ++k) {
        step = circle_step<Real>(start, point, n, plane, circle);
        circle += step;
    }
    const Vector3<Real> centre = plane.origin + plane.e1 * circle[0] + plane.e2 * circle[1];
    SpaceCircle<Real> found;
    for (int i = 0; i < 3; ++i) {
        found.centre[i] = Real(start.centre[i]) + Real(start.axes(i, 0)) * centre[0] +
                          Real(start.axes(i, 1)) * centre[1] + Real(start.axes(i, 2)) * centre[2];
        found.normal[i] = Real(start.axes(i, 0)) * plane.n[0] + Real(start.axes(i, 1)) * plane.n[1] +
                          Real(start.axes(i, 2)) * plane.n[2];
    }
    found.radius = circle[2];
    found.converged = step.dot(step) < circle[2] * circle[2] * Real(1e-18);
    return found;
}

/// Shape of the points about a start, in double.
struct CircleShape {
    CircleStart start;           ///< normal on the side from which the points run anticlockwise
    Eigen::Vector3d extents;     ///< root mean square along the principal axes, falling
    double arc = 0.0;            ///< angle from the first point to the last, signed by the order: > 0
    std::vector<double> angles;  ///< angles of the points around the centre, from the first on
};
/// Principal axes, algebraic circle, then the geometric fit. Needs three points or more.
CircleShape circle_shape(std::span<const Eigen::Vector3d> points);

}  // namespace covaria
