// The equations of "pose from points", once for every number type (Porath et al., Eqs 9-23, corrected).
#pragma once

#include "core/kinds/pose/setup.h"
#include "core/math/registration.h"

namespace covaria::pose {

/// A frame in frame 0: axes by columns, and its origin.
template <class Real>
struct Frame {
    Matrix3<Real> R;
    Vector3<Real> o;
    mask_of<Real> valid;
};

template <class Real, class In>
Vector3<Real> point(const In& x, std::size_t first) {
    return {Real(x[first]), Real(x[first + 1]), Real(x[first + 2])};
}

/// Frame from three points: axes by Eqs 9-16, origin by Eqs 17 and 18.
template <class Real, class In>
Frame<Real> frame_3_2_1(const FrameRule& rule, const In& x, std::size_t first) {
    const Vector3<Real> q1 = point<Real>(x, first), q2 = point<Real>(x, first + 3),
                        q3 = point<Real>(x, first + 6);
    const Matrix3<Real> R = axes_3_2_1(q1, q2, q3, rule.third_point);
    const Vector3<Real> s = rule.shift.cast<Real>();
    return {R, q1 + R * s, mask_of<Real>(true)};
}

/// Frame whose local coordinates fit the points best: min sum |q_i - (o + R l_i)|^2.
template <class Real, class In>
Frame<Real> frame_least_squares(const FrameRule& rule, const In& x, std::size_t first) {
    const auto& l = rule.centred;
    const Vector3<Real> q1 = point<Real>(x, first);  // differences from q1: frame 0 may be far away
    Matrix3<Real> H = Matrix3<Real>::Zero();
    Vector3<Real> sum = Vector3<Real>::Zero();
    for (std::size_t i = 1; i < l.size(); ++i) {
        const Vector3<Real> d = point<Real>(x, first + 3 * i) - q1;
        const Vector3<Real> li = l[i].template cast<Real>();
        H += d * li.transpose();
        sum += d;
    }
    Matrix3<Real> R;
    const mask_of<Real> valid = registration(H, R);
    const Vector3<Real> c = rule.centroid.cast<Real>();
    const Vector3<Real> o = q1 + sum * Real(1.0 / static_cast<double>(l.size())) - R * c;
    return {R, o, valid};
}

template <class Real, class In>
Frame<Real> frame(const FrameRule& rule, const In& x, std::size_t first) {
    return rule.least_squares ? frame_least_squares<Real>(rule, x, first) : frame_3_2_1<Real>(rule, x, first);
}

/// Computes all poses of a trial; they share the base frame. Inputs b_1x, b_1y, b_1z, b_2x ..., then the
/// moving points of each pose; outputs x, y, z and the coordinates of the orientation for each pose.
template <class Real, class In, class Out>
mask_of<Real> all_poses(const PoseSetup& setup, const In& x, Out& y) {
    const std::size_t angles = rotation_convention(setup.orientation).coordinates.size();
    const std::size_t per_pose = 3 * setup.moving.points.size();
    std::size_t in = 3 * setup.base.points.size(), out = 0;
    const Frame<Real> b = frame<Real>(setup.base, x, 0);
    const Matrix3<Real> Rb_T = b.R.transpose();
    mask_of<Real> valid = b.valid;
    for (std::size_t k = 0; k < setup.poses.size(); ++k, in += per_pose) {
        const Frame<Real> p = frame<Real>(setup.moving, x, in);
        valid = valid && p.valid;
        const Vector3<Real> d = p.o - b.o;
        const Vector3<Real> o_bp = Rb_T * d;                                     // Eq 19, corrected
        const Matrix3<Real> R_bp = Rb_T * p.R;                                   // Eq 20, corrected
        const auto orientation = rotation_coordinates(setup.orientation, R_bp);  // Eqs 21-23, corrected
        for (int i = 0; i < 3; ++i) y.set(out++, o_bp[i]);
        for (std::size_t i = 0; i < angles; ++i) y.set(out++, orientation[i]);
    }
    return valid;
}

}  // namespace covaria::pose
