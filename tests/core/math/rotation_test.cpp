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

Matrix3<double> rotation_of(RotationConvention convention, const std::array<double, 4>& v) {
    switch (convention) {
        case RotationConvention::zyx:
            return rotation_from_zyx<double>({v[0], v[1], v[2]});
        case RotationConvention::zyz:
            return rotation_from_zyz<double>({v[0], v[1], v[2]});
        case RotationConvention::rotation_vector:
            return rotation_from_vector<double>({v[0], v[1], v[2]});
        case RotationConvention::quaternion:
            break;
    }
    return rotation_from_quaternion(v);
}

// Rotations at the singularities of each convention, a little off them, and with rounding left in them.
std::vector<Matrix3<double>> singular_rotations() {
    std::vector<Matrix3<double>> all;
    for (double off : {0.0, 1e-17, 1e-16, 1e-15, 1e-12, 1e-9, 1e-8, 1e-6, 1e-3})
        for (double sign : {-1.0, 1.0})
            for (double a = -pi; a <= pi; a += pi / 6)
                for (double c : {-3.0, -pi / 2, 0.0, 0.7, 2.2}) {
                    all.push_back(rotation_from_zyx<double>({a, pi / 2 + sign * off, c}));
                    all.push_back(rotation_from_zyx<double>({a, -pi / 2 + sign * off, c}));
                    all.push_back(rotation_from_zyz<double>({a, sign * off, c}));
                    all.push_back(rotation_from_zyz<double>({a, pi + sign * off, c}));
                    all.push_back(Eigen::AngleAxisd(pi + sign * off,
                                                    Eigen::Vector3d(std::cos(a), std::sin(a), c).normalized())
                                      .toRotationMatrix());
                    all.push_back(Eigen::AngleAxisd(sign * off,
                                                    Eigen::Vector3d(std::cos(a), std::sin(a), c).normalized())
                                      .toRotationMatrix());
                }
    for (int axis = 0; axis < 24; ++axis) {  // signed permutations: every entry -1, 0 or 1
        Matrix3<double> R = Matrix3<double>::Zero();
        const int i = axis % 3, j = (i + 1 + axis / 3 % 2) % 3;
        R.col(0)[i] = axis / 6 % 2 ? -1.0 : 1.0;
        R.col(1)[j] = axis / 12 ? -1.0 : 1.0;
        R.col(2) = R.col(0).cross(R.col(1));
        all.push_back(R);
    }
    return all;
}

TEST(Rotation, EveryConventionLeadsBackToTheSameRotationEverywhere) {
    std::vector<Matrix3<double>> all = rotations();
    for (const Matrix3<double>& R : singular_rotations()) all.push_back(R);
    for (const Matrix3<double>& R : all)
        for (const RotationConventionInfo& info : rotation_conventions()) {
            const std::array<double, 4> v = rotation_coordinates(info.convention, R);
            EXPECT_LT((rotation_of(info.convention, v) - R).norm(), 2e-15) << info.key << "\n" << R;
            const std::array<Batch, 4> lanes = rotation_coordinates(info.convention, R.cast<Batch>().eval());
            const std::array<double, 4> lane{lanes[0].get(1), lanes[1].get(1), lanes[2].get(1),
                                             lanes[3].get(1)};
            EXPECT_LT((rotation_of(info.convention, lane) - R).norm(), 2e-15) << info.key << "\n" << R;
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
