// Distances and angles with their u, against differences of finite steps and against trials.
#include "core/result/point_measures.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <numbers>
#include <random>

namespace covaria::point_measures_test {
namespace {

using Vector = Eigen::Vector3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// A covariance matrix with correlations everywhere; standard uncertainties of about `scale`.
template <int n>
Eigen::Matrix<double, n, n> a_covariance(double scale) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    Eigen::Matrix<double, n, n> a;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) a(i, j) = scale * normal(random) / std::sqrt(n);
    return a * a.transpose();
}

const Vector a(0.4, -0.2, 1.1), apex(0.1, 0.3, 0.2), b(-0.7, 0.9, 0.5);

template <int n, class F>
double u_by_differences(const Eigen::Matrix<double, n, n>& V, const Eigen::Matrix<double, n, 1>& x,
                        const F& f) {
    Eigen::Matrix<double, n, 1> gradient;
    for (int i = 0; i < n; ++i) {
        Eigen::Matrix<double, n, 1> low = x, high = x;
        low[i] -= 1e-5;
        high[i] += 1e-5;
        gradient[i] = (f(high) - f(low)) / 2e-5;
    }
    return std::sqrt(gradient.dot(V * gradient));
}

double angle_of(const Eigen::Matrix<double, 9, 1>& x) {
    const Vector p = x.segment<3>(0) - x.segment<3>(3), q = x.segment<3>(6) - x.segment<3>(3);
    return std::acos(p.dot(q) / (p.norm() * q.norm()));
}

TEST(PointMeasures, DistanceHasTheJointCovariance) {
    const Matrix6 V = a_covariance<6>(1e-4);
    const PointMeasure measure = measured_distance(a, b, V);
    EXPECT_DOUBLE_EQ(measure.value, (b - a).norm());
    Eigen::Matrix<double, 6, 1> x;
    x << a, b;
    const double expected = u_by_differences<6>(
        V, x, [](const auto& p) { return (p.template tail<3>() - p.template head<3>()).norm(); });
    EXPECT_NEAR(measure.standard_uncertainty, expected, 1e-8 * expected);
    EXPECT_TRUE(measure.linear);
}

TEST(PointMeasures, WhatBothPointsShareCancels) {
    Matrix6 V = Matrix6::Zero();
    V.topLeftCorner<3, 3>() = V.bottomRightCorner<3, 3>() = 1e-6 * Eigen::Matrix3d::Identity();
    const double apart = measured_distance(a, b, V).standard_uncertainty;
    EXPECT_NEAR(apart, std::sqrt(2.0) * 1e-3, 1e-12);
    V.topRightCorner<3, 3>() = V.bottomLeftCorner<3, 3>() = 1e-6 * Eigen::Matrix3d::Identity();
    EXPECT_NEAR(measured_distance(a, b, V).standard_uncertainty, 0.0, 1e-12);
}

TEST(PointMeasures, AngleHasTheJointCovariance) {
    const Matrix9 V = a_covariance<9>(1e-4);
    Eigen::Matrix<double, 9, 1> x;
    x << a, apex, b;
    const PointMeasure measure = measured_angle(a, apex, b, V);
    EXPECT_NEAR(measure.value, angle_of(x), 1e-12);
    const double expected = u_by_differences<9>(V, x, angle_of);
    EXPECT_NEAR(measure.standard_uncertainty, expected, 1e-7 * expected);
    EXPECT_TRUE(measure.linear);
}

TEST(PointMeasures, TrialsAgreeWhereTheFirstOrderIsSaidToHold) {
    constexpr int trials = 20'000;
    const Matrix9 V = a_covariance<9>(2e-3);
    const Matrix9 root = V.llt().matrixL();
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    Eigen::Matrix<double, 9, 1> x, z;
    x << a, apex, b;
    double sum = 0, squares = 0;
    for (int t = 0; t < trials; ++t) {
        for (int i = 0; i < 9; ++i) z[i] = normal(random);
        const double d = angle_of(x + root * z) - angle_of(x);
        sum += d;
        squares += d * d;
    }
    const PointMeasure measure = measured_angle(a, apex, b, V);
    ASSERT_TRUE(measure.linear);
    const double u = std::sqrt(squares / trials - (sum / trials) * (sum / trials));
    EXPECT_NEAR(u, measure.standard_uncertainty, 4 * u / std::sqrt(2.0 * trials));
}

TEST(PointMeasures, NothingIsStatedWhereTheFirstOrderFails) {
    const Matrix6 V = 1e-6 * Matrix6::Identity();
    EXPECT_FALSE(measured_distance(a, a, V).linear) << "one place";
    EXPECT_FALSE(measured_distance(a, a + Vector(2e-3, 0, 0), V).linear) << "closer than two u";
    EXPECT_TRUE(measured_distance(a, a + Vector(0.1, 0, 0), V).linear);
    const Matrix9 W = 1e-6 * Matrix9::Identity();
    EXPECT_FALSE(measured_angle(a, a, b, W).linear);
    const Vector beyond = apex + 2 * (a - apex);
    EXPECT_EQ(measured_angle(a, apex, beyond, W).value, 0.0);
    EXPECT_FALSE(measured_angle(a, apex, beyond, W).linear);
    EXPECT_NEAR(measured_angle(a, apex, 2 * apex - a, W).value, std::numbers::pi, 1e-7);
    EXPECT_FALSE(measured_angle(a, apex, 2 * apex - a, W).linear);
    EXPECT_FALSE(measured_angle(a, apex, apex + Vector(5e-3, 0, 0), W).linear) << "a way of five u";
}

TEST(PointMeasures, NoUncertaintyGivesNone) {
    EXPECT_EQ(measured_distance(a, b, Matrix6::Zero()).standard_uncertainty, 0.0);
    EXPECT_TRUE(measured_distance(a, b, Matrix6::Zero()).linear);
}

}  // namespace
}  // namespace covaria::point_measures_test
