// Rotations: there and back in every convention, the textbook forms, and the places where they are undefined.
#include "core/math/rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace covaria::rotation_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double deg = pi / 180.0;

std::vector<Matrix3<double>> rotations() {
    std::vector<Matrix3<double>> all;
    for (double a : {-170.0, -90.0, -5.0, 0.0, 1e-7, 5.0, 100.0, 179.0})
        for (double b : {-80.0, -5.0, 0.0, 3.0, 85.0})
            for (double c : {-179.0, -30.0, 0.0, 12.0, 120.0})
                all.push_back(rotation_from_zyx<double>({a * deg, b * deg, c * deg}));
    return all;
}

TEST(Rotation, ElementaryRotationsAreThoseOfEigen) {
    const Eigen::Matrix3d expected =
        (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(-0.7, Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitX()))
            .toRotationMatrix();
    EXPECT_LT((rotation_from_zyx<double>({1.1, -0.7, 0.3}) - expected).norm(), 1e-15);
    const Eigen::Matrix3d zyz =
        (Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    EXPECT_LT((rotation_from_zyz<double>({1.1, 0.7, 0.3}) - zyz).norm(), 1e-15);
}

TEST(Rotation, EveryConventionLeadsBackToTheSameRotation) {
    for (const Matrix3<double>& R : rotations()) {
        EXPECT_LT((rotation_from_zyx(zyx_from_rotation(R)) - R).norm(), 1e-14);
        if (regularity(RotationConvention::zyz, R) > 1e-6) {
            EXPECT_LT((rotation_from_zyz(zyz_from_rotation(R)) - R).norm(), 1e-14);
        }
        EXPECT_LT((rotation_from_quaternion(quaternion_from_rotation(R)) - R).norm(), 1e-14);
        EXPECT_LT((rotation_from_vector(rotation_vector_from_rotation(R)) - R).norm(), 1e-14);
    }
}

TEST(Rotation, TheRotationVectorIsThatOfEigen) {
    for (const Matrix3<double>& R : rotations()) {
        const Eigen::AngleAxisd expected(R);
        EXPECT_LT((rotation_vector_from_rotation(R) - expected.angle() * expected.axis()).norm(), 1e-13);
        EXPECT_GE(quaternion_from_rotation(R)[0], 0.0);
    }
}

TEST(Rotation, BatchesEqualDoubles) {
    for (const Matrix3<double>& R : rotations()) {
        const Matrix3<Batch> RB = R.cast<Batch>();
        for (const RotationConventionInfo& info : rotation_conventions()) {
            if (regularity(info.convention, R) < 1e-6) continue;
            const auto expected = rotation_coordinates(info.convention, R);
            const auto found = rotation_coordinates(info.convention, RB);
            for (std::size_t i = 0; i < 4; ++i)
                EXPECT_NEAR(std::remainder(found[i].get(0) - expected[i], 2 * pi), 0.0, 1e-14) << info.key;
        }
    }
}

TEST(Rotation, DerivativesAreThoseOfDifferences) {
    const Vector3<double> angles(0.2, -0.4, 2.1);
    Vector3<Dual> seeded;
    for (std::size_t i = 0; i < 3; ++i)
        seeded[static_cast<int>(i)] = Dual::variable(angles[static_cast<int>(i)], i);
    for (const RotationConventionInfo& info : rotation_conventions()) {
        const auto exact = rotation_coordinates(info.convention, rotation_from_zyx(seeded));
        for (int i = 0; i < 3; ++i) {
            Vector3<double> above = angles, below = angles;
            above[i] += 1e-5;
            below[i] -= 1e-5;
            const auto a = rotation_coordinates(info.convention, rotation_from_zyx(above));
            const auto b = rotation_coordinates(info.convention, rotation_from_zyx(below));
            for (std::size_t j = 0; j < 4; ++j)
                EXPECT_NEAR(exact[j].partials()[static_cast<std::size_t>(i)], (a[j] - b[j]) / 2e-5, 1e-8)
                    << info.key;
        }
    }
}

TEST(Rotation, DerivativesOfTheRotationVectorAreFiniteAtNoRotation) {
    Vector3<Dual> r;
    for (std::size_t i = 0; i < 3; ++i) r[static_cast<int>(i)] = Dual::variable(0.0, i);
    const Vector3<Dual> back = rotation_vector_from_rotation(rotation_from_vector(r));
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(back[static_cast<int>(i)].partials()[k], i == k ? 1.0 : 0.0, 1e-12);
}

TEST(Rotation, RegularityTellsGimbalLock) {
    EXPECT_NEAR(regularity(RotationConvention::zyx, rotation_from_zyx<double>({0.1, 90 * deg, 0.3})), 0.0,
                1e-15);
    EXPECT_NEAR(regularity(RotationConvention::zyx, rotation_from_zyx<double>({0.1, 60 * deg, 0.3})), 0.5,
                1e-15);
    EXPECT_NEAR(regularity(RotationConvention::zyz, Matrix3<double>::Identity()), 0.0, 1e-15);
    EXPECT_NEAR(regularity(RotationConvention::rotation_vector, rotation_x(pi)), 0.0, 1e-8);
    EXPECT_NEAR(regularity(RotationConvention::quaternion, Matrix3<double>::Identity()), 1.0, 1e-15);
}

TEST(Rotation, ConventionsAreFoundByTheirKey) {
    for (const RotationConventionInfo& info : rotation_conventions()) {
        EXPECT_EQ(rotation_convention_from(info.key), info.convention);
        EXPECT_EQ(rotation_convention(info.convention).key, info.key);
    }
}

}  // namespace
}  // namespace covaria::rotation_test
