// The functions of equations for the three number types, beside those of core/math.
#pragma once

#include <cmath>
#include <numbers>

#include "core/math/dual.h"
#include "core/math/real.h"

namespace covaria {

inline Dual atan(const Dual& x) {
    return Dual::chain(std::atan(x.value()), x, 1.0 / (1.0 + x.value() * x.value()));
}
inline Dual sinh(const Dual& x) {
    return Dual::chain(std::sinh(x.value()), x, std::cosh(x.value()));
}
inline Dual cosh(const Dual& x) {
    return Dual::chain(std::cosh(x.value()), x, std::sinh(x.value()));
}
inline Dual tanh(const Dual& x) {
    const double t = std::tanh(x.value());
    return Dual::chain(t, x, 1.0 - t * t);
}
inline Dual asinh(const Dual& x) {
    return Dual::chain(std::asinh(x.value()), x, 1.0 / std::sqrt(x.value() * x.value() + 1.0));
}
inline Dual acosh(const Dual& x) {
    return Dual::chain(std::acosh(x.value()), x, 1.0 / std::sqrt(x.value() * x.value() - 1.0));
}
inline Dual atanh(const Dual& x) {
    return Dual::chain(std::atanh(x.value()), x, 1.0 / (1.0 - x.value() * x.value()));
}
inline Dual cbrt(const Dual& x) {
    const double root = std::cbrt(x.value());
    return Dual::chain(root, x, 1.0 / (3.0 * root * root));
}
inline Dual log10(const Dual& x) {
    return Dual::chain(std::log10(x.value()), x, 1.0 / (x.value() * std::numbers::ln10));
}
inline Dual log2(const Dual& x) {
    return Dual::chain(std::log2(x.value()), x, 1.0 / (x.value() * std::numbers::ln2));
}

namespace equation {

/// The number itself, without derivatives.
inline double plain(double x) {
    return x;
}
inline double plain(const Dual& x) {
    return x.value();
}
inline const Batch& plain(const Batch& x) {
    return x;
}

inline bool is_constant(const Dual& x) {
    for (const double partial : x.partials())
        if (partial != 0.0) return false;
    return true;
}

/// x^n by squaring: exact for small whole numbers, negative bases too.
template <class Real>
Real integer_power(const Real& x, double n) {
    Real result(1.0), factor = x;
    for (auto bits = static_cast<unsigned>(std::abs(n)); bits != 0; bits >>= 1u) {
        if (bits & 1u) result = result * factor;
        if (bits > 1u) factor = factor * factor;
    }
    return n < 0.0 ? Real(1.0) / result : result;
}

template <class Real>
Real general_power(const Real& x, const Real& p) {
    using namespace real_functions;
    return pow(x, p);
}
/// The derivative by the exponent, log x, is asked for only where the exponent varies.
inline Dual general_power(const Dual& x, const Dual& p) {
    return is_constant(p) ? pow(x, p.value()) : pow(x, p);
}

/// Value of a condition as registers keep it: one where true, zero elsewhere.
template <class Real, class Mask>
Real truth(const Mask& mask) {
    using namespace real_functions;
    return select(mask, Real(1.0), Real(0.0));
}
template <class Real>
mask_of<Real> is_true(const Real& x) {
    return x > Real(0.5);
}

template <class Real>
Real sign_of(const Real& x) {
    using namespace real_functions;
    const Real positive = select(x > Real(0.0), Real(1.0), Real(0.0));
    return select(x < Real(0.0), Real(-1.0), positive);
}

template <class Real>
Real absolute(const Real& x) {
    using namespace real_functions;
    return select(x < Real(0.0), -x, x);
}
template <class Real>
Real smaller(const Real& a, const Real& b) {
    using namespace real_functions;
    return select(b < a, b, a);
}
template <class Real>
Real larger(const Real& a, const Real& b) {
    using namespace real_functions;
    return select(a < b, b, a);
}

}  // namespace equation

}  // namespace covaria
