// Frames from points: 3-2-1, and which points make no frame.
#include "core/math/frames.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"

namespace covaria::frames_test {
namespace {

const std::vector<Eigen::Vector3d> local{
    {-0.3, 0.2, 0.0}, {0.3, 0.2, 0.01}, {0.0, -0.4, 0.0}, {0.1, 0.1, 0.2}};

TEST(Frames, TheThirdPointGivesTheSide) {
    const Eigen::Vector3d a(0, 0, 0), b(2, 0, 0), above(1, 1, 0), below(1, -1, 0);
    const auto identity = Eigen::Matrix3d::Identity();
    EXPECT_LT((axes_3_2_1<double>(a, b, above, ThirdPoint::positive_y) - identity).norm(), 1e-15);
    EXPECT_LT((axes_3_2_1<double>(a, b, below, ThirdPoint::negative_y) - identity).norm(), 1e-15);
    const Eigen::Matrix3d turned = axes_3_2_1<double>(a, b, below, ThirdPoint::positive_y);
    EXPECT_LT((turned - Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix()).norm(), 1e-15);
}

TEST(Frames, AxesFollowTheRotationOfThePoints) {
    const Matrix3<double> R = rotation_from_zyx<double>({0.3, -0.8, 2.5});
    const Eigen::Vector3d shift(10, -20, 5), a(0.1, 0.2, 0), b(0.7, 0.2, 0), c(0.3, 0.9, 0);
    const Matrix3<double> found =
        axes_3_2_1<double>(R * a + shift, R * b + shift, R * c + shift, ThirdPoint::positive_y);
    EXPECT_LT((found - R).norm(), 1e-13);
}

TEST(Frames, CollinearPointsHaveNoCorner) {
    EXPECT_EQ(sine_of_corner({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0.0);
    EXPECT_EQ(sine_of_corner({0, 0, 0}, {0, 0, 0}, {2, 0, 0}), 0.0);
    EXPECT_NEAR(sine_of_corner({0, 0, 0}, {1, 0, 0}, {0, 3, 0}), 1.0, 1e-15);
    EXPECT_LT(spread_off_a_line(std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {5, 5, 0}}),
              1e-7);
    EXPECT_GT(spread_off_a_line(local), 0.3);
    EXPECT_EQ(spread_off_a_line(std::vector<Eigen::Vector3d>(4, Eigen::Vector3d(1, 2, 3))), 0.0);
}

}  // namespace
}  // namespace covaria::frames_test
