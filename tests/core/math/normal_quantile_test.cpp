// The inverse normal distribution function against Boost.Math, and its independence of blocking.
#include "core/math/normal_quantile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace covaria::normal_quantile_test {
namespace {

/// The quantile in extended precision, so that the reference is correct to the last bit of a double.
double reference_quantile(double p) {
    const long double q = static_cast<long double>(p);
    const long double root2 = std::numbers::sqrt2_v<long double>;
    return static_cast<double>(p < 0.5 ? -root2 * boost::math::erfc_inv(2 * q)
                                       : root2 * boost::math::erf_inv(2 * q - 1));
}

std::vector<double> probabilities() {
    std::vector<double> p;
    for (int k = -1000; k <= -1; ++k) p.push_back(std::ldexp(1.0, k));
    for (int k = -53; k <= -2; ++k) p.push_back(1.0 - std::ldexp(1.0, k));
    for (int i = 1; i < 4000; ++i) p.push_back(i / 4000.0);
    for (const double edge : {0.075, 0.925, 1.3887943864964021e-11})  // changes of formula: r = 5
        for (const double step : {-1e-15, 0.0, 1e-15}) p.push_back(edge * (1.0 + step));
    return p;
}

TEST(NormalQuantile, AgreesWithBoost) {
    double worst = 0.0;
    for (const double p : probabilities()) {
        const double expected = reference_quantile(p);
        const double found = normal_quantile(p);
        if (expected == 0.0) {
            EXPECT_EQ(found, 0.0);
            continue;
        }
        worst = std::max(worst, std::abs(found / expected - 1.0));
    }
    EXPECT_LT(worst, 1.5e-15);
    EXPECT_GT(worst, 0.0);
}

TEST(NormalQuantile, IsOddWherever1MinusPIsExact) {
    for (int k = 2; k <= 53; ++k) {
        const double p = std::ldexp(1.0, -k);
        EXPECT_EQ(normal_quantile(p), -normal_quantile(1.0 - p)) << k;
    }
    EXPECT_EQ(normal_quantile(0.5), 0.0);
}

TEST(NormalQuantile, IsMonotoneToTheExtremes) {
    std::vector<double> p = probabilities();
    std::sort(p.begin(), p.end());
    double last = -std::numeric_limits<double>::infinity();
    for (const double x : p) {
        const double z = normal_quantile(x);
        EXPECT_GE(z, last - 1e-15 * std::abs(last)) << x;
        last = z;
    }
    EXPECT_NEAR(normal_quantile(std::ldexp(1.0, -53)), -8.2095361516013856, 1e-14);
}

TEST(NormalQuantile, LimitsAndArgumentsOutside) {
    EXPECT_EQ(normal_quantile(0.0), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(normal_quantile(1.0), std::numeric_limits<double>::infinity());
    for (const double bad :
         {-0.1, 1.1, -1e300, std::numeric_limits<double>::quiet_NaN(),
          std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
        EXPECT_TRUE(std::isnan(normal_quantile(bad))) << bad;
}

TEST(NormalQuantile, ElementsDoNotDependOnTheirNeighbours) {
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<double> p(1500);
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] = i % 11 == 0 ? 1e-14 * (uniform(generator) + 1e-3) : uniform(generator);
    std::vector<double> whole(p.size());
    normal_quantiles(p, whole);
    for (const std::size_t block : {1, 3, 4, 7, 255, 256, 257, 1024}) {
        std::vector<double> parts = p;  // in place
        for (std::size_t begin = 0; begin < p.size(); begin += block) {
            const std::size_t length = std::min(block, p.size() - begin);
            const std::span<double> part(parts.data() + begin, length);
            normal_quantiles(part, part);
        }
        EXPECT_EQ(parts, whole) << block;
    }
    for (std::size_t i = 0; i < p.size(); i += 13) EXPECT_EQ(normal_quantile(p[i]), whole[i]);
    normal_quantiles({}, {});
}

TEST(NormalQuantile, IsTheSameWithAnyWidthOfVectors) {
    if (!has_avx512()) GTEST_SKIP() << "a processor without AVX-512";
    std::mt19937_64 random(7);
    std::vector<double> p = probabilities();
    while (p.size() < 20'003) p.push_back(std::uniform_real_distribution<double>(0.0, 1.0)(random));
    std::shuffle(p.begin(), p.end(), random);
    for (const std::size_t size :
         {std::size_t{1}, std::size_t{7}, std::size_t{256}, std::size_t{259}, p.size()}) {
        const std::span<const double> some(p.data(), size);
        std::vector<double> narrow(size), wide(size);
        detail::normal_quantiles_avx2(some, narrow);
        detail::normal_quantiles_avx512(some, wide);
        EXPECT_EQ(narrow, wide) << size;
    }
}

TEST(NormalDistributionFunction, InvertsTheQuantile) {
    for (const double p : {1e-300, 1e-12, 0.001, 0.3, 0.5, 0.9, 0.999})
        EXPECT_NEAR(normal_distribution_function(normal_quantile(p)) / p, 1.0, 1e-12) << p;
    EXPECT_DOUBLE_EQ(normal_distribution_function(0.0), 0.5);
}

TEST(NormalDistributionFunction, VectorAgreesWithSingleForm) {
    std::vector<double> z;
    for (int i = -800; i <= 800; ++i) z.push_back(i / 97.0);
    std::vector<double> p(z.size());
    normal_distribution_functions(z, p);
    for (std::size_t i = 0; i < z.size(); ++i) {
        const double expected = normal_distribution_function(z[i]);
        EXPECT_NEAR(p[i], expected, std::min(1e-11 * expected, 5e-15)) << z[i];
        double single = 0.0;
        normal_distribution_functions({&z[i], 1}, {&single, 1});
        EXPECT_EQ(single, p[i]) << z[i];
    }
}

TEST(NormalDensity, IsTheDerivative) {
    for (const double z : {-3.0, -0.5, 0.0, 1.0, 2.5}) {
        const double h = 1e-5;
        const double slope =
            (normal_distribution_function(z + h) - normal_distribution_function(z - h)) / (2.0 * h);
        EXPECT_NEAR(normal_density(z), slope, 1e-10);
    }
}

}  // namespace
}  // namespace covaria::normal_quantile_test
