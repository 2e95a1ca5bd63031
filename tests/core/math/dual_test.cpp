// Dual numbers: every function against central differences.
#include "core/math/dual.h"

#include <gtest/gtest.h>

namespace covaria::dual_test {
namespace {

template <class Real>
Real arithmetic(const Real& a, const Real& b) {
    using namespace real_functions;
    Real r = a * b + a / b - b;
    r += Real(2.0) * a;
    r -= b / Real(3.0);
    r *= a;
    r /= b;
    return -r + select(a < b, a, b) + min(a, b) * max(a, b) + abs(a - b);
}

template <class Real>
Real transcendental(const Real& a, const Real& b) {
    using namespace real_functions;
    return sqrt(a) + sin(a) * cos(b) + tan(a) + asin(a) + acos(a) + atan2(a, b) + hypot(a, b) + exp(a) +
           log(b) + pow(a, 1.7) + pow(a, b);
}

TEST(Dual, DerivativesAgreeWithCentralDifferences) {
    const double a = 0.4, b = 1.3, h = 1e-5;
    const auto check = [&](auto&& dual, auto&& plain) {
        const Dual y = dual(Dual::variable(a, 0), Dual::variable(b, 7));
        EXPECT_DOUBLE_EQ(y.value(), plain(a, b));
        EXPECT_NEAR(y.partials()[0], (plain(a + h, b) - plain(a - h, b)) / (2 * h), 1e-8);
        EXPECT_NEAR(y.partials()[7], (plain(a, b + h) - plain(a, b - h)) / (2 * h), 1e-8);
        for (std::size_t k = 1; k < 7; ++k) EXPECT_EQ(y.partials()[k], 0.0);
    };
    check(arithmetic<Dual>, arithmetic<double>);
    check(transcendental<Dual>, transcendental<double>);
}

TEST(Dual, WorksAsAScalarOfEigen) {
    const Vector3<Dual> a(Dual::variable(1.0, 0), Dual(2.0), Dual(3.0));
    const Vector3<Dual> b(Dual(-1.0), Dual::variable(0.5, 1), Dual(2.0));
    const Vector3<Dual> c = a.cross(b);
    EXPECT_DOUBLE_EQ(c[2].value(), 1.0 * 0.5 + 2.0);
    EXPECT_DOUBLE_EQ(c[2].partials()[0], 0.5);
    EXPECT_DOUBLE_EQ(c[2].partials()[1], 1.0);
    EXPECT_DOUBLE_EQ(a.norm().partials()[0], 1.0 / std::sqrt(14.0));
}

}  // namespace
}  // namespace covaria::dual_test
