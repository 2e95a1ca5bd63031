// Operations on strips of values: one function per operation and number type.
#pragma once

#include <array>

#include "core/equation/operations.h"
#include "core/equation/real_functions.h"

namespace covaria::equation {

/// y[i] = operation(a[i], b[i], c[i]) for i < width.
template <class Real>
using Kernel = void (*)(Real* y, const Real* a, const Real* b, const Real* c, double value,
                        std::size_t width);

namespace detail {

template <class Real, class F>
struct Elementwise {
    static void run(Real* y, const Real* a, const Real* b, const Real* c, double value, std::size_t width) {
        for (std::size_t i = 0; i < width; ++i) y[i] = F::template at<Real>(a[i], b[i], c[i], value);
    }
};

#define COVARIA_OPERATION(Name, expression)                                                        \
    struct Name {                                                                                  \
        template <class Real>                                                                      \
        static Real at([[maybe_unused]] const Real& a, [[maybe_unused]] const Real& b,             \
                       [[maybe_unused]] const Real& c, [[maybe_unused]] double value) {            \
            using namespace real_functions;                                                        \
            using std::acosh, std::asinh, std::atan, std::atanh, std::cbrt, std::cosh, std::log10, \
                std::log2, std::sinh, std::tanh;                                                   \
            return expression;                                                                     \
        }                                                                                          \
    };

COVARIA_OPERATION(Nothing, a)
COVARIA_OPERATION(Add, a + b)
COVARIA_OPERATION(Subtract, a - b)
COVARIA_OPERATION(Multiply, a* b)
COVARIA_OPERATION(Divide, a / b)
COVARIA_OPERATION(Negate, -a)
COVARIA_OPERATION(Power, general_power(a, b))
COVARIA_OPERATION(IntegerPower, integer_power(a, value))
COVARIA_OPERATION(Less, truth<Real>(a < b))
COVARIA_OPERATION(LessOrEqual, truth<Real>(a <= b))
COVARIA_OPERATION(Greater, truth<Real>(a > b))
COVARIA_OPERATION(GreaterOrEqual, truth<Real>(a >= b))
COVARIA_OPERATION(Equal, truth<Real>(a == b))
COVARIA_OPERATION(NotEqual, Real(1.0) - truth<Real>(a == b))
COVARIA_OPERATION(And, a* b)
COVARIA_OPERATION(Or, larger(a, b))
COVARIA_OPERATION(Not, Real(1.0) - a)
COVARIA_OPERATION(Select, select(is_true(a), b, c))
COVARIA_OPERATION(SquareRoot, sqrt(a))
COVARIA_OPERATION(CubeRoot, cbrt(a))
COVARIA_OPERATION(Exponential, exp(a))
COVARIA_OPERATION(Logarithm, log(a))
COVARIA_OPERATION(Logarithm10, log10(a))
COVARIA_OPERATION(Logarithm2, log2(a))
COVARIA_OPERATION(Sine, sin(a))
COVARIA_OPERATION(Cosine, cos(a))
COVARIA_OPERATION(Tangent, tan(a))
COVARIA_OPERATION(ArcSine, asin(a))
COVARIA_OPERATION(ArcCosine, acos(a))
COVARIA_OPERATION(ArcTangent, atan(a))
COVARIA_OPERATION(HyperbolicSine, sinh(a))
COVARIA_OPERATION(HyperbolicCosine, cosh(a))
COVARIA_OPERATION(HyperbolicTangent, tanh(a))
COVARIA_OPERATION(AreaSine, asinh(a))
COVARIA_OPERATION(AreaCosine, acosh(a))
COVARIA_OPERATION(AreaTangent, atanh(a))
COVARIA_OPERATION(Absolute, absolute(a))
COVARIA_OPERATION(Sign, sign_of(a))
COVARIA_OPERATION(ArcTangent2, atan2(a, b))
COVARIA_OPERATION(Hypotenuse, hypot(a, b))
COVARIA_OPERATION(Minimum, smaller(a, b))
COVARIA_OPERATION(Maximum, larger(a, b))
#undef COVARIA_OPERATION

template <class Real, class... F>
constexpr std::array<Kernel<Real>, sizeof...(F)> kernels_of() {
    return {&Elementwise<Real, F>::run...};
}

}  // namespace detail

/// Kernel of an operation, from a table in the order of `Operation`; the four that compute nothing first.
template <class Real>
Kernel<Real> kernel(Operation operation) {
    using namespace detail;
    static constexpr auto table =
        kernels_of<Real, Nothing, Nothing, Nothing, Nothing, Add, Subtract, Multiply, Divide, Negate, Power,
                   IntegerPower, Less, LessOrEqual, Greater, GreaterOrEqual, Equal, NotEqual, And, Or, Not,
                   Select, SquareRoot, CubeRoot, Exponential, Logarithm, Logarithm10, Logarithm2, Sine,
                   Cosine, Tangent, ArcSine, ArcCosine, ArcTangent, HyperbolicSine, HyperbolicCosine,
                   HyperbolicTangent, AreaSine, AreaCosine, AreaTangent, Absolute, Sign, ArcTangent2,
                   Hypotenuse, Minimum, Maximum>();
    static_assert(table.size() == operations);
    return table[static_cast<std::size_t>(operation)];
}

}  // namespace covaria::equation
