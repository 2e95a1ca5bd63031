// Decompositions say when they did not succeed.
#include "core/math/decompositions.h"

#include <gtest/gtest.h>

#include <limits>

namespace covaria::decompositions_test {

namespace {

Eigen::Matrix2d symmetric(double a, double b, double c) {
    Eigen::Matrix2d m;
    m << a, b, b, c;
    return m;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST(Decompositions, FactorsOfAPositiveMatrix) {
    const Eigen::Matrix2d m = symmetric(4.0, 2.0, 3.0);
    const Eigen::Matrix2d lower = cholesky(m).matrixL();
    EXPECT_LT((lower * lower.transpose() - m).norm(), 1e-14);
    EXPECT_THROW(cholesky(symmetric(1.0, 2.0, 1.0)), ImpossibleValue) << "not positive definite";
    EXPECT_THROW(cholesky(symmetric(1.0, nan, 1.0)), ImpossibleValue);
}

TEST(Decompositions, EigenvaluesAndSingularValues) {
    EXPECT_NEAR(eigen_decomposition(symmetric(2.0, 1.0, 2.0)).eigenvalues()[1], 3.0, 1e-14);
    EXPECT_THROW(eigen_decomposition(symmetric(nan, 1.0, 2.0)), ImpossibleValue);
    EXPECT_NEAR(singular_values(symmetric(3.0, 0.0, -5.0)).singularValues()[0], 5.0, 1e-14);
    EXPECT_THROW(singular_values(symmetric(1.0, std::numeric_limits<double>::infinity(), 2.0)),
                 ImpossibleValue);
}

TEST(Decompositions, AStepThatCannotBeIsNone) {
    const auto step = damped_step(symmetric(2.0, 0.0, 4.0), Eigen::Vector2d(2.0, 2.0));
    ASSERT_TRUE(step);
    EXPECT_LT((*step - Eigen::Vector2d(1.0, 0.5)).norm(), 1e-15);
    EXPECT_FALSE(damped_step(symmetric(nan, 0.0, 4.0), Eigen::Vector2d(2.0, 2.0)));
    EXPECT_FALSE(damped_step(symmetric(0.0, 1.0, 0.0), Eigen::Vector2d(1.0, 1.0))) << "no factors L D L^T";
    EXPECT_FALSE(damped_step(symmetric(1e-300, 0.0, 1.0), Eigen::Vector2d(1e300, 1.0))) << "overflows";
}

}  // namespace covaria::decompositions_test
