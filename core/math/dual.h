// Forward-mode dual numbers: a value with its partial derivatives with respect to eight quantities.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/math/real.h"

namespace covaria {

class Dual {
public:
    static constexpr std::size_t size = 8;
    using Partials = std::array<double, size>;

    Dual(double value = 0.0) : value_(value) {}  // implicit: constants of the equations
    /// The quantity number `direction` itself: dx_i/dx_i = 1.
    static Dual variable(double value, std::size_t direction) {
        Dual x(value);
        x.partials_[direction] = 1.0;
        return x;
    }

    double value() const { return value_; }
    const Partials& partials() const { return partials_; }

    /// f(x) with f'(x) = slope.
    static Dual chain(double value, const Dual& x, double slope) {
        Dual y(value);
        for (std::size_t k = 0; k < size; ++k) y.partials_[k] = slope * x.partials_[k];
        return y;
    }
    /// f(a, b) with the partial derivatives fa and fb.
    static Dual chain(double value, const Dual& a, double fa, const Dual& b, double fb) {
        Dual y(value);
        for (std::size_t k = 0; k < size; ++k) y.partials_[k] = fa * a.partials_[k] + fb * b.partials_[k];
        return y;
    }

    friend Dual operator+(const Dual& a, const Dual& b) { return chain(a.value_ + b.value_, a, 1.0, b, 1.0); }
    friend Dual operator-(const Dual& a, const Dual& b) {
        return chain(a.value_ - b.value_, a, 1.0, b, -1.0);
    }
    friend Dual operator*(const Dual& a, const Dual& b) {
        return chain(a.value_ * b.value_, a, b.value_, b, a.value_);
    }
    friend Dual operator/(const Dual& a, const Dual& b) {
        const double quotient = a.value_ / b.value_;
        return chain(quotient, a, 1.0 / b.value_, b, -quotient / b.value_);
    }
    Dual operator-() const { return chain(-value_, *this, -1.0); }
    Dual& operator+=(const Dual& b) {
        value_ += b.value_;
        for (std::size_t k = 0; k < size; ++k) partials_[k] += b.partials_[k];
        return *this;
    }
    Dual& operator-=(const Dual& b) {
        value_ -= b.value_;
        for (std::size_t k = 0; k < size; ++k) partials_[k] -= b.partials_[k];
        return *this;
    }
    Dual& operator*=(const Dual& b) { return *this = *this * b; }
    Dual& operator/=(const Dual& b) { return *this = *this / b; }

    friend bool operator<(const Dual& a, const Dual& b) { return a.value_ < b.value_; }
    friend bool operator>(const Dual& a, const Dual& b) { return a.value_ > b.value_; }
    friend bool operator<=(const Dual& a, const Dual& b) { return a.value_ <= b.value_; }
    friend bool operator>=(const Dual& a, const Dual& b) { return a.value_ >= b.value_; }
    friend bool operator==(const Dual& a, const Dual& b) { return a.value_ == b.value_; }

private:
    double value_;
    Partials partials_{};
};

inline Dual sqrt(const Dual& x) {
    const double root = std::sqrt(x.value());
    return Dual::chain(root, x, 0.5 / root);
}
inline Dual sin(const Dual& x) {
    return Dual::chain(std::sin(x.value()), x, std::cos(x.value()));
}
inline Dual cos(const Dual& x) {
    return Dual::chain(std::cos(x.value()), x, -std::sin(x.value()));
}
inline Dual tan(const Dual& x) {
    const double tangent = std::tan(x.value());
    return Dual::chain(tangent, x, 1.0 + tangent * tangent);
}
inline Dual asin(const Dual& x) {
    return Dual::chain(std::asin(x.value()), x, 1.0 / std::sqrt(1.0 - x.value() * x.value()));
}
inline Dual acos(const Dual& x) {
    return Dual::chain(std::acos(x.value()), x, -1.0 / std::sqrt(1.0 - x.value() * x.value()));
}
inline Dual atan2(const Dual& y, const Dual& x) {
    const double r2 = x.value() * x.value() + y.value() * y.value();
    return Dual::chain(std::atan2(y.value(), x.value()), y, x.value() / r2, x, -y.value() / r2);
}
inline Dual hypot(const Dual& a, const Dual& b) {
    const double r = std::hypot(a.value(), b.value());
    return Dual::chain(r, a, a.value() / r, b, b.value() / r);
}
inline Dual exp(const Dual& x) {
    const double e = std::exp(x.value());
    return Dual::chain(e, x, e);
}
inline Dual log(const Dual& x) {
    return Dual::chain(std::log(x.value()), x, 1.0 / x.value());
}
/// x^p for a constant p.
inline Dual pow(const Dual& x, double p) {
    return Dual::chain(std::pow(x.value(), p), x, p * std::pow(x.value(), p - 1.0));
}
/// x^p for x > 0.
inline Dual pow(const Dual& x, const Dual& p) {
    const double power = std::pow(x.value(), p.value());
    return Dual::chain(power, x, p.value() * std::pow(x.value(), p.value() - 1.0), p,
                       power * std::log(x.value()));
}
inline Dual abs(const Dual& x) {
    return x.value() < 0.0 ? -x : x;
}
inline Dual min(const Dual& a, const Dual& b) {
    return b < a ? b : a;
}
inline Dual max(const Dual& a, const Dual& b) {
    return a < b ? b : a;
}

}  // namespace covaria

namespace Eigen {

template <>
struct NumTraits<covaria::Dual> : GenericNumTraits<double> {
    using Real = covaria::Dual;
    using NonInteger = covaria::Dual;
    using Nested = covaria::Dual;
    using Literal = double;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 1,
        AddCost = 8,
        MulCost = 16
    };
};

}  // namespace Eigen
