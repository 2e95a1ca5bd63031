// The batch as a number type: the same functions under the same names, lane by lane equal to double.
#include <gtest/gtest.h>

#include "core/math/real.h"

namespace covaria::simd_number_test {
namespace {

Batch lanes(double a, double b, double c, double d) {
    const double values[4] = {a, b, c, d};
    return Batch::load_unaligned(values);
}

template <class Real>
Real all_functions(const Real& a, const Real& b) {
    using namespace real_functions;
    const Real c = a / (a + b);
    return sqrt(a) + sin(a) * cos(b) - tan(a) + asin(c) * acos(c) + atan2(a, -b) + hypot(a, b) + exp(-a) +
           log(b) + pow(a, b) + abs(a - b) + min(a, b) * max(a, b) + select(a < b, a, Real(b * b));
}

static_assert(Batch::size == 4, "the release baseline is x86-64-v3");

TEST(SimdNumber, FunctionsEqualThoseOfDoubleToRounding) {
    const std::array<double, 4> a{0.1, 0.9, 1.4, 7.0}, b{3.0, 0.2, 1.4, 0.5};
    double y[4];
    all_functions(Batch::load_unaligned(a.data()), Batch::load_unaligned(b.data())).store_unaligned(y);
    for (std::size_t k = 0; k < 4; ++k) {
        const double expected = all_functions(a[k], b[k]);
        EXPECT_NEAR(y[k], expected, 4e-15 * std::max(1.0, std::abs(expected))) << k;
    }
}

TEST(SimdNumber, TheArcTangentHasAllQuadrants) {
    const double xs[] = {1.0, -1.0, 0.0, 1e-8, -1e-8, 1e6}, ys[] = {0.0, 1.0, -1.0, 1e-12, -1e-12, 3.0};
    for (double y : ys)
        for (double x : xs) {
            if (x == 0.0 && y == 0.0) continue;
            double value[4];
            xsimd::atan2(Batch(y), Batch(x)).store_unaligned(value);
            EXPECT_NEAR(value[0], std::atan2(y, x), 1e-15 * 4) << y << " " << x;
        }
}

TEST(SimdNumber, WorksAsAScalarOfEigen) {
    const Vector3<Batch> a(lanes(1, 2, 3, 4), Batch(2.0), Batch(-1.0));
    const Vector3<Batch> b(Batch(0.5), Batch(1.0), lanes(1, 0, 1, 0));
    double c[4], n[4];
    a.cross(b)[1].store_unaligned(c);
    a.norm().store_unaligned(n);
    for (int k = 0; k < 4; ++k) {
        const Eigen::Vector3d p(k + 1, 2, -1), q(0.5, 1, k % 2 ? 0 : 1);
        EXPECT_DOUBLE_EQ(c[k], p.cross(q)[1]);
        EXPECT_DOUBLE_EQ(n[k], p.norm());
    }
}

}  // namespace
}  // namespace covaria::simd_number_test
