// The transform of one joint in Denavit-Hartenberg conventions, applied to points and to poses.
#pragma once

#include <array>

#include "core/math/dual.h"
#include "core/math/real.h"

namespace covaria {

enum class JointParameter { theta, d, a, alpha, beta };
inline constexpr std::array<JointParameter, 5> joint_parameters{
    JointParameter::theta, JointParameter::d, JointParameter::a, JointParameter::alpha, JointParameter::beta};

enum class DhConvention {
    modified,  ///< T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta), Wen et al., Eq 5; standard DH where beta = 0
    craig,     ///< T = Rx(alpha) Tx(a) Rz(theta) Tz(d): alpha and a lead to the axis of the joint
};

template <class Real>
struct JointValues {
    Real theta = Real(0.0), d = Real(0.0), a = Real(0.0), alpha = Real(0.0), beta = Real(0.0);
    Real& operator[](JointParameter p) {
        return p == JointParameter::theta   ? theta
               : p == JointParameter::d     ? d
               : p == JointParameter::a     ? a
               : p == JointParameter::alpha ? alpha
                                            : beta;
    }
    const Real& operator[](JointParameter p) const { return const_cast<JointValues&>(*this)[p]; }
};

template <class Real>
struct Turn {
    Real c = Real(1.0), s = Real(0.0);  // braces would pick the batch's initializer list
    Turn() = default;
    Turn(const Real& cosine, const Real& sine) : c(cosine), s(sine) {}
    explicit Turn(const Real& angle) {
        using namespace real_functions;
        c = cos(angle);
        s = sin(angle);
    }
    /// The sum of the two angles.
    Turn operator*(const Turn& b) const { return {Real(c * b.c - s * b.s), Real(s * b.c + c * b.s)}; }
};
template <>
inline Turn<Batch>::Turn(const Batch& angle) {
    const auto both = xsimd::sincos(angle);
    s = both.first;
    c = both.second;
}

/// A joint of one trial, its angles as cosines and sines.
template <class Real>
struct JointTransform {
    Turn<Real> theta, alpha, beta;
    Real d = Real(0.0), a = Real(0.0);
    bool has_beta = false;
};

/// (u, v) turned: u' = c u − s v, v' = s u + c v.
template <class Real>
void turn_coordinates(const Turn<Real>& t, Real& u, Real& v) {
    const Real was = u;
    u = t.c * was - t.s * v;
    v = t.s * was + t.c * v;
}

/// p in the joint's frame becomes p in the frame before it.
template <class Real>
void apply(DhConvention convention, const JointTransform<Real>& T, Vector3<Real>& p) {
    if (convention == DhConvention::craig) {
        turn_coordinates(T.theta, p[0], p[1]);
        p[2] += T.d;
        turn_coordinates(T.alpha, p[1], p[2]);
        p[0] += T.a;
        return;
    }
    if (T.has_beta) turn_coordinates(T.beta, p[2], p[0]);
    turn_coordinates(T.alpha, p[1], p[2]);
    p[0] += T.a;
    turn_coordinates(T.theta, p[0], p[1]);
    p[2] += T.d;
}

/// Applies the transform to all three axes of a pose, without the translation.
template <class Real>
void apply_to_axes(DhConvention convention, const JointTransform<Real>& T, Matrix3<Real>& R) {
    for (int k = 0; k < 3; ++k) {
        Real &x = R(0, k), &y = R(1, k), &z = R(2, k);
        if (convention == DhConvention::craig) {
            turn_coordinates(T.theta, x, y);
            turn_coordinates(T.alpha, y, z);
            continue;
        }
        if (T.has_beta) turn_coordinates(T.beta, z, x);
        turn_coordinates(T.alpha, y, z);
        turn_coordinates(T.theta, x, y);
    }
}

template <class Real>
JointTransform<Real> joint_transform(const JointValues<Real>& v, bool has_beta) {
    JointTransform<Real> T;
    T.theta = Turn<Real>(v.theta);
    T.alpha = Turn<Real>(v.alpha);
    if (has_beta) T.beta = Turn<Real>(v.beta);
    T.d = v.d;
    T.a = v.a;
    T.has_beta = has_beta;
    return T;
}

}  // namespace covaria
