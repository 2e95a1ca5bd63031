// Least-squares registration against the singular value decomposition of every trial by itself: rails,
// strips, plates, mirrored points, noise wider than the points.
#include "core/math/registration.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <random>

namespace covaria::registration_test {
namespace {

using Points = Eigen::Matrix3Xd;

struct Case {
    const char* name;
    Eigen::Vector3d size;
    int points;
    double noise;
};

const Case cases[] = {{"block", {1, 1, 1}, 5, 1e-3},
                      {"block, noisy", {1, 1, 1}, 5, 0.3},
                      {"plate", {1, 0.8, 0}, 6, 1e-3},
                      {"plate, noisy", {1, 0.8, 0}, 6, 0.2},
                      {"three points", {1, 1, 0}, 3, 0.01},
                      {"strip", {1, 0.008, 0}, 40, 1e-3},
                      {"narrow strip", {1, 0.003, 0}, 40, 3e-3},
                      {"rail", {3, 0.02, 0}, 12, 5e-4},
                      {"bar", {1, 0.002, 0.002}, 8, 2e-3},
                      {"no noise", {1, 0.5, 0.2}, 4, 0.0},
                      {"thin", {1, 1e-4, 1e-4}, 10, 1e-6},
                      {"nothing but noise", {1e-3, 1e-3, 1e-3}, 6, 1}};

class Trials {
public:
    explicit Trials(const Case& c, unsigned seed) : case_(c), generator_(seed), local_(3, c.points) {
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        for (int i = 0; i < c.points; ++i)
            for (int k = 0; k < 3; ++k) local_(k, i) = c.size[k] * uniform(generator_);
        local_.colwise() -= local_.rowwise().mean().eval();
    }

    const Points& local() const { return local_; }

    Points measured(bool mirrored) {
        std::normal_distribution<double> normal;
        const Eigen::Quaterniond q =
            Eigen::Quaterniond(normal(generator_), normal(generator_), normal(generator_), normal(generator_))
                .normalized();
        Points p = q.toRotationMatrix() * local_;
        if (mirrored) p.row(2) = -p.row(2);
        for (int i = 0; i < p.cols(); ++i)
            for (int k = 0; k < 3; ++k) p(k, i) += case_.noise * normal(generator_);
        return p;
    }

private:
    Case case_;
    std::mt19937 generator_;
    Points local_;
};

/// Kabsch: the rotation, and how far its maximum is from the next stationary value.
struct Reference {
    Eigen::Matrix3d R;
    double gap, largest;
};

Reference reference(const Eigen::Matrix3d& H) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1.0 : 1.0;
    const Eigen::Vector3d s = svd.singularValues();
    return {svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose(),
            s[1] + sign * s[2], s[0]};
}

void expect_maximum(const Eigen::Matrix3d& H, const Eigen::Matrix3d& R, const char* what) {
    const Reference expected = reference(H);
    EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-14) << what;
    EXPECT_GT(R.determinant(), 0.9) << what;
    EXPECT_GE((R.transpose() * H).trace(), (expected.R.transpose() * H).trace() - 1e-14 * H.norm()) << what;
    EXPECT_LT((R - expected.R).norm(), 1e-14 * (1.0 + expected.largest / expected.gap)) << what;
}

TEST(Registration, IsTheGlobalMaximumForEveryShapeOfPoints) {
    unsigned seed = 1;
    for (const Case& c : cases)
        for (bool mirrored : {false, true}) {
            Trials trials(c, seed++);
            for (int t = 0; t < 300; ++t) {
                std::array<Eigen::Matrix3d, Batch::size> H;
                Matrix3<Batch> lanes;
                for (Eigen::Matrix3d& lane : H) lane = trials.measured(mirrored) * trials.local().transpose();
                for (int i = 0; i < 9; ++i) {
                    double values[Batch::size];
                    for (std::size_t k = 0; k < Batch::size; ++k) values[k] = H[k](i / 3, i % 3);
                    lanes(i / 3, i % 3) = Batch::load_unaligned(values);
                }
                Matrix3<Batch> R_lanes;
                EXPECT_TRUE(xsimd::all(registration(lanes, R_lanes))) << c.name;
                for (std::size_t k = 0; k < Batch::size; ++k) {
                    Matrix3<double> R, lane;
                    EXPECT_TRUE(registration(H[k], R)) << c.name;
                    for (int i = 0; i < 9; ++i) lane(i / 3, i % 3) = R_lanes(i / 3, i % 3).get(k);
                    expect_maximum(H[k], R, c.name);
                    expect_maximum(H[k], lane, c.name);
                }
            }
        }
}

TEST(Registration, DoesNotDependOnTheOtherLanes) {
    Trials easy(cases[0], 5), hard(cases[6], 6);
    const Eigen::Matrix3d H = easy.measured(false) * easy.local().transpose(),
                          other = hard.measured(true) * hard.local().transpose();
    Matrix3<Batch> alone = H.cast<Batch>(), mixed, R_alone, R_mixed;
    for (int i = 0; i < 9; ++i) {
        double values[Batch::size];
        std::fill(values, values + Batch::size, other(i / 3, i % 3));
        values[0] = H(i / 3, i % 3);
        mixed(i / 3, i % 3) = Batch::load_unaligned(values);
    }
    registration(alone, R_alone);
    registration(mixed, R_mixed);
    for (int i = 0; i < 9; ++i) EXPECT_EQ(R_alone(i / 3, i % 3).get(0), R_mixed(i / 3, i % 3).get(0));
}

TEST(Registration, PointsOnALineDetermineNoRotation) {
    Matrix3<double> R;
    EXPECT_FALSE(registration<double>(Matrix3<double>::Zero(), R));
    const Eigen::Vector3d along(0.3, -0.2, 0.9);
    EXPECT_FALSE(registration<double>(along * along.transpose(), R));
    EXPECT_FALSE(registration<double>(-Matrix3<double>::Identity(), R)) << "every half turn does as well";
}

TEST(Registration, DerivativesAreThoseOfDifferences) {
    unsigned seed = 50;
    for (const Case& c : cases) {
        if (c.noise > 0.01) continue;
        Trials trials(c, seed++);
        const Points q = trials.measured(false);
        const auto solution = [&](auto h) {
            using Real = decltype(h);
            Matrix3<Real> H = Matrix3<Real>::Zero(), R;
            for (int i = 0; i < q.cols(); ++i) {
                Vector3<Real> point = q.col(i).cast<Real>();
                if (i == 1)
                    for (int k = 0; k < 3; ++k) point[k] = point[k] + h * Real(0.3 * k - 0.2);
                const Vector3<Real> l = trials.local().col(i).cast<Real>();
                H += point * l.transpose();
            }
            EXPECT_TRUE(registration(H, R)) << c.name;
            return R;
        };
        const double step = 1e-3 * std::max(c.size[1], 1e-3);
        const Matrix3<Dual> exact = solution(Dual::variable(0.0, 0));
        const Matrix3<double> above = solution(step), below = solution(-step);
        Matrix3<double> slope;
        for (int i = 0; i < 9; ++i) slope(i / 3, i % 3) = exact(i / 3, i % 3).partials()[0];
        EXPECT_LT((slope - (above - below) / (2 * step)).norm(), 1e-4 * slope.norm()) << c.name;
    }
}

}  // namespace
}  // namespace covaria::registration_test
