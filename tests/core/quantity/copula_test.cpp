// Coefficients of the Gaussian copula against closed forms and exact extremes.
#include "core/quantity/copula.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace covaria::copula_test {
namespace {

InputSet two(const Distribution& a, const Distribution& b, double r) {
    InputSet inputs;
    inputs.add({.symbol = "x"}, {{.id = "a", .name = "a", .distribution = a}});
    inputs.add({.symbol = "y"}, {{.id = "b", .name = "b", .distribution = b}});
    inputs.correlations = {{0, 1, r}};
    return inputs;
}

Result<double> rho(const Distribution& a, const Distribution& b, double r) {
    const InputSet inputs = two(a, b, r);
    return detail::copula_coefficients(inputs, inputs.correlations).map([](const auto& solved) {
        return solved.front().coefficient;
    });
}

TEST(Copula, ClosedForms) {
    constexpr double pi = std::numbers::pi;
    const Distribution normal = Distribution::of(Normal{3.0, 2.0});
    const Distribution rectangular = Distribution::of(Rectangular{-1.0, 4.0});
    const auto lognormal = [](double s) { return Distribution::of(Lognormal{0.5, s}); };
    for (const double r : {-0.9, -0.3, 0.2, 0.7, 0.95}) {
        EXPECT_EQ(*rho(normal, normal, r), r);
        EXPECT_NEAR(*rho(rectangular, rectangular, r), 2.0 * std::sin(pi * r / 6.0), 1e-7);
        EXPECT_NEAR(*rho(rectangular.scaled(7.0), rectangular.shifted(2.0), r), 2.0 * std::sin(pi * r / 6.0),
                    1e-7);
        EXPECT_NEAR(*rho(normal, rectangular, r), r * std::sqrt(pi / 3.0), 1e-7);
        const double s = 0.4, t = 0.3;
        const double wanted = std::log1p(r * std::sqrt(std::expm1(s * s) * std::expm1(t * t))) / (s * t);
        if (std::abs(wanted) >= 1.0) continue;
        EXPECT_NEAR(*rho(lognormal(s), lognormal(t), r), wanted, 1e-7);
    }
}

TEST(Copula, RefusesWhatTheDistributionsCannotHave) {
    const Distribution exponential = Distribution::of(Exponential{2.0});
    EXPECT_TRUE(rho(exponential, exponential, 0.9));
    EXPECT_TRUE(rho(exponential, exponential, -0.64));  // lowest: 1 - pi^2/6 = -0.645
    const auto refused = rho(exponential, exponential, -0.9);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message.english(),
              "the components \"a\" (exponential) and \"b\" (exponential) cannot have the correlation -0.9: "
              "with these distributions it lies between -0.645 and 1.");
    EXPECT_TRUE(rho(exponential, exponential.scaled(-1.0), -0.9)) << "mirrored";
    EXPECT_FALSE(rho(exponential, exponential.scaled(-1.0), 0.9));
    EXPECT_FALSE(resolved_correlations(two(exponential, exponential, -0.9)));
    EXPECT_NEAR(*rho(Distribution::normal(1.0), Distribution::of(Rectangular{0.0, 1.0}), 0.98), 1.0, 1e-12)
        << "two digits of the largest possible, sqrt(3/pi) = 0.977";
}

TEST(Copula, ArithmeticCombinationAndWhatHasNoCorrelationStay) {
    InputSet inputs;
    inputs.add({.symbol = "x", .combination = Combination::arithmetic},
               {{.id = "a", .name = "a", .distribution = Distribution::normal(1.0)},
                {.id = "b", .name = "b", .distribution = Distribution::of(Exponential{1.0})}});
    const auto resolved = resolved_correlations(inputs);
    ASSERT_TRUE(resolved) << resolved.error().message.english();
    EXPECT_EQ(detail::copula_coefficients(inputs, *resolved)->front().coefficient, 1.0);
    const Distribution cauchy = Distribution::of(StudentT{0.0, 1.0, 1.0});
    EXPECT_EQ(*rho(cauchy, Distribution::normal(1.0), 0.99), 0.99);
    EXPECT_EQ(*rho(Distribution(), Distribution::of(Exponential{1.0}), -0.99), -0.99);
}

TEST(Copula, NearestCorrelationIsPositiveSemidefinite) {
    Eigen::Matrix3d m;
    m << 1, 0, 0.7236, 0, 1, 0.7236, 0.7236, 0.7236, 1;
    const Eigen::MatrixXd near = detail::nearest_correlation(m);
    EXPECT_GT(near.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -1e-12);
    EXPECT_LT((near.diagonal().array() - 1.0).abs().maxCoeff(), 1e-12);
    EXPECT_LT((near - m).cwiseAbs().maxCoeff(), 0.03);
    m(0, 2) = m(2, 0) = 0.5;
    EXPECT_EQ(detail::nearest_correlation(m), m);
}

}  // namespace
}  // namespace covaria::copula_test
