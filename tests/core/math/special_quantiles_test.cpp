// Quantiles of t, chi-squared and F against tables, and coverage factors.
#include "core/math/special_quantiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/math/normal_quantile.h"

namespace covaria::special_quantiles_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(SpecialQuantiles, StudentTAsInTableG2) {  // JCGM 100 table G.2: two-sided t_p(nu)
    EXPECT_NEAR(t_density(0.0, 4.0), 0.375, 1e-15);
    EXPECT_NEAR(t_density(-1.0, 1.0), 0.5 / M_PI, 1e-15) << "Cauchy";
    EXPECT_NEAR(t_density(1.0, INFINITY), std::exp(-0.5) / std::sqrt(2.0 * M_PI), 1e-15);
    EXPECT_TRUE(std::isnan(t_density(0.0, 0.0)));
    EXPECT_NEAR(t_quantile(0.975, 1), 12.71, 0.005);
    EXPECT_NEAR(t_quantile(0.975, 4), 2.78, 0.005);
    EXPECT_NEAR(t_quantile(0.995, 16), 2.92, 0.005);
    EXPECT_NEAR(t_quantile(0.5 * (1 + 0.9545), 50), 2.05, 0.005);
    EXPECT_NEAR(t_quantile(0.975, 2), std::sqrt(2.0) * 0.95 / std::sqrt(1 - 0.95 * 0.95),
                1e-12);  // closed form
    EXPECT_EQ(t_quantile(0.5, 7), 0.0);
    EXPECT_DOUBLE_EQ(t_quantile(0.1, 3.5), -t_quantile(0.9, 3.5));
}

TEST(SpecialQuantiles, StudentTTendsToTheNormal) {
    EXPECT_EQ(t_quantile(0.975, infinite), normal_quantile(0.975));
    EXPECT_NEAR(t_quantile(0.975, 1e6), normal_quantile(0.975), 1e-5);
    EXPECT_NEAR(t_quantile(0.975, 1e14), normal_quantile(0.975), 1e-12);
}

TEST(SpecialQuantiles, ChiSquaredAsInJcgm102) {  // JCGM 102 table 1: k_p of ellipsoids
    EXPECT_NEAR(std::sqrt(chi_squared_quantile(0.95, 2)), 2.4477, 5e-5);
    EXPECT_NEAR(std::sqrt(chi_squared_quantile(0.95, 3)), 2.7955, 5e-5);
    EXPECT_NEAR(chi_squared_quantile(0.3, 2), -2.0 * std::log(0.7), 1e-13);
    EXPECT_NEAR(chi_squared_upper_tail(3.0, 2), std::exp(-1.5), 1e-15);
    for (const double dof : {1.0, 3.0, 250.0})
        EXPECT_NEAR(chi_squared_upper_tail(chi_squared_quantile(0.99, dof), dof), 0.01, 1e-13) << dof;
}

TEST(SpecialQuantiles, FTendsToChiSquaredAndIsTSquared) {
    EXPECT_NEAR(f_quantile(0.95, 1, 7), std::pow(t_quantile(0.975, 7), 2), 1e-11);
    EXPECT_DOUBLE_EQ(f_quantile(0.95, 3, infinite), chi_squared_quantile(0.95, 3) / 3.0);
    EXPECT_NEAR(f_quantile(0.95, 3, 1e7), chi_squared_quantile(0.95, 3) / 3.0, 1e-5);
}

TEST(SpecialQuantiles, TheUpperTailOfFInvertsItsQuantile) {
    for (const double p : {0.001, 0.3, 0.95, 0.9999})
        for (const double nu : {1.0, 2.5, 40.0})
            EXPECT_NEAR(f_upper_tail(f_quantile(p, nu, 7.0), nu, 7.0), 1.0 - p, 1e-12);
    EXPECT_EQ(f_upper_tail(0.0, 3, 4), 1.0);
    EXPECT_TRUE(std::isnan(f_upper_tail(-1.0, 3, 4)));
}

TEST(SpecialQuantiles, BadArgumentsGiveNaN) {
    const double nan_value = std::numeric_limits<double>::quiet_NaN();
    for (const double p : {0.0, 1.0, -1.0, 2.0, nan_value}) {
        EXPECT_TRUE(std::isnan(t_quantile(p, 3)));
        EXPECT_TRUE(std::isnan(chi_squared_quantile(p, 3)));
        EXPECT_TRUE(std::isnan(f_quantile(p, 3, 4)));
    }
    for (const double nu : {0.0, -1.0, nan_value}) {
        EXPECT_TRUE(std::isnan(t_quantile(0.9, nu)));
        EXPECT_TRUE(std::isnan(chi_squared_quantile(0.9, nu)));
        EXPECT_TRUE(std::isnan(chi_squared_upper_tail(0.9, nu)));
        EXPECT_TRUE(std::isnan(f_quantile(0.9, nu, 4)));
        EXPECT_TRUE(std::isnan(f_quantile(0.9, 4, nu)));
    }
}

TEST(CoverageFactor, IsTheTwoSidedQuantile) {
    EXPECT_NEAR(*coverage_factor(0.95, infinite), 1.959963984540054, 1e-15);
    EXPECT_NEAR(*coverage_factor(0.9545, infinite), 2.0, 1e-4);
    EXPECT_NEAR(*coverage_factor(0.99, 16), t_quantile(0.995, 16), 1e-13);
    EXPECT_FALSE(coverage_factor(1.0, 5).has_value());
    EXPECT_FALSE(coverage_factor(0.0, 5).has_value());
    EXPECT_FALSE(coverage_factor(0.95, 0.0).has_value());
    EXPECT_FALSE(coverage_factor(0.95, std::nan("")).has_value());
}

}  // namespace
}  // namespace covaria::special_quantiles_test
