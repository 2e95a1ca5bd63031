// Frames from points: 3-2-1 and least squares, against Eigen's closed-form registration.
#include "core/math/frames.h"

#include <gtest/gtest.h>

#include <random>

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

// Points turned by R and disturbed by `noise`: the refined rotation must be the one of Umeyama's closed form.
void expect_registration(const Matrix3<double>& R, double noise, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0.0, noise);
    Eigen::Matrix3Xd from(3, 4), to(3, 4);
    for (int i = 0; i < 4; ++i) {
        from.col(i) = local[static_cast<std::size_t>(i)];
        to.col(i) =
            R * from.col(i) + Eigen::Vector3d(normal(generator), normal(generator), normal(generator));
    }
    const Eigen::Matrix3d expected = Eigen::umeyama(from, to, false).topLeftCorner<3, 3>();
    const Eigen::Vector3d cf = from.rowwise().mean(), ct = to.rowwise().mean();
    const Matrix3<double> H = (to.colwise() - ct) * (from.colwise() - cf).transpose();
    Matrix3<double> found =
        axes_3_2_1<double>(to.col(0), to.col(1), to.col(2), ThirdPoint::negative_y) *
        axes_3_2_1<double>(from.col(0), from.col(1), from.col(2), ThirdPoint::negative_y).transpose();
    EXPECT_TRUE(refine_registration(H, found));
    EXPECT_LT((found - expected).norm(), 1e-12);
    Matrix3<Batch> lanes = (R.transpose() * R * R).eval().cast<Batch>();
    EXPECT_TRUE(xsimd::all(refine_registration<Batch>(H.cast<Batch>(), lanes)));
    EXPECT_LT(std::abs(lanes(0, 1).get(2) - expected(0, 1)), 1e-12);
}

TEST(Frames, RegistrationIsTheLeastSquaresSolution) {
    unsigned seed = 1;
    for (double noise : {0.0, 1e-4, 1e-2, 0.04})
        for (int k = 0; k < 20; ++k)
            expect_registration(rotation_from_zyx<double>({0.3 * k, 0.1 * k - 1.0, -0.2 * k}), noise, seed++);
}

TEST(Frames, DerivativesOfTheRegistrationAreThoseOfDifferences) {
    const Matrix3<double> R0 = rotation_from_zyx<double>({0.02, -0.01, 0.03});
    const auto solution = [&](auto h) {
        using Real = decltype(h);
        Matrix3<Real> H = Matrix3<Real>::Zero();
        for (std::size_t i = 0; i < local.size(); ++i) {
            Vector3<Real> q = (R0 * local[i]).cast<Real>();
            if (i == 1) q[2] = q[2] + h;
            const Vector3<Real> l = local[i].cast<Real>();
            H += q * l.transpose();
        }
        Matrix3<Real> R = Matrix3<Real>::Identity();
        EXPECT_TRUE(refine_registration(H, R));
        return R;
    };
    const Matrix3<Dual> exact = solution(Dual::variable(0.01, 0));
    const Matrix3<double> above = solution(0.01 + 1e-6), below = solution(0.01 - 1e-6);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(exact(i, j).partials()[0], (above(i, j) - below(i, j)) / 2e-6, 1e-8);
}

}  // namespace
}  // namespace covaria::frames_test
