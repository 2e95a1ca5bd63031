// Five hundred simulated campaigns of redundant readings: factors are unbiased, stated intervals cover,
// alarms come at their level; where the likeliest components lie.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "core/evidence/seen.h"

namespace covaria::campaigns_test {

using evidence::RedundantReadings;
using evidence::Seen;

inline constexpr int campaigns = 500;

/// Random deviations of readings; the part that unknowns take up is of no consequence.
inline Eigen::VectorXd deviations(const RedundantReadings& readings, const std::vector<double>& truth,
                                  std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const auto noise = [&](Eigen::Index n) {
        Eigen::VectorXd e(n);
        for (double& value : e) value = normal(random);
        return e;
    };
    if (!readings.shares.empty()) {
        Eigen::VectorXd e = Eigen::VectorXd::Zero(readings.residuals.size());
        if (readings.others.cols() > 0) e = readings.others * noise(readings.others.cols());
        for (std::size_t k = 0; k < readings.shares.size(); ++k)
            e += truth[k] * readings.shares[k] * noise(readings.shares[k].cols());
        return e;
    }
    Eigen::VectorXd e = noise(readings.residuals.size());
    for (Eigen::Index i = 0; i < e.size(); ++i)
        e[i] *= truth[readings.figure_of[static_cast<std::size_t>(i)]] / readings.whitening.coeff(i, i);
    return e;
}

/// The properties of a figure that are held against its truth.
enum class Hold {
    all,
    /// Those that users rely upon, without the mean: variances are positive, so that a figure whose estimate
    /// would be negative stands at zero instead, and takes its excess from the others.
    coverage_and_alarms,
};

/// `truth`: of each figure, over what is stated. `held`: how many of the first figures have enough redundancy
/// to be held against it; the others are drawn with theirs.
inline void expect_campaigns(const RedundantReadings& stated, const std::vector<double>& truth, unsigned seed,
                             std::size_t held = static_cast<std::size_t>(-1), Hold hold = Hold::all) {
    ASSERT_EQ(stated.figures.size(), truth.size());
    RedundantReadings readings = stated;
    std::mt19937_64 random(seed);
    held = std::min(held, truth.size());
    std::vector<double> sum(truth.size()), squares(truth.size());
    std::vector<int> covered(truth.size()), alarms(truth.size());
    for (int c = 0; c < campaigns; ++c) {
        readings.residuals = deviations(readings, truth, random);
        const Seen seen = evidence::see(readings);
        ASSERT_TRUE(seen.found);
        for (std::size_t k = 0; k < held; ++k) {
            const evidence::SeenFigure& figure = seen.figures[k];
            ASSERT_GE(figure.redundancy, evidence::least_redundancy) << k;
            sum[k] += figure.square;
            squares[k] += figure.square * figure.square;
            covered[k] += figure.low <= truth[k] && truth[k] <= figure.high;
            alarms[k] += figure.verdict != evidence::Verdict::agrees;
        }
    }
    for (std::size_t k = 0; k < held; ++k) {
        const double mean = sum[k] / campaigns;
        const double s = std::sqrt((squares[k] - campaigns * mean * mean) / (campaigns - 1.0));
        if (hold == Hold::all) {
            EXPECT_NEAR(mean, truth[k] * truth[k], 2.0 * s / std::sqrt(campaigns)) << k;
        }
        EXPECT_GE(covered[k], 0.93 * campaigns) << k;
        EXPECT_LE(covered[k], 0.97 * campaigns) << k;
        // A right figure is contradicted by chance.
        if (truth[k] == 1.0) {
            EXPECT_NEAR(alarms[k], 0.05 * campaigns, 2.0 * std::sqrt(0.05 * 0.95 * campaigns)) << k;
        }
        std::printf("figure %zu: mean factor² %.4f of %.4f (u %.4f), covered %.1f %%\n", k, mean,
                    truth[k] * truth[k], s / std::sqrt(campaigns), 100.0 * covered[k] / campaigns);
    }
}

/// Slopes of the likelihood of residuals by the components of shared figures, straight from the formula, each
/// over its redundancy and scaled by its component as stated.
inline Eigen::VectorXd slopes(const RedundantReadings& readings, const Seen& seen) {
    const Eigen::MatrixXd A = readings.design;
    Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(A.rows(), A.rows());
    if (readings.others.cols() > 0) Q = readings.others * readings.others.transpose();
    for (std::size_t k = 0; k < readings.shares.size(); ++k)
        Q += seen.figures[k].square * readings.shares[k] * readings.shares[k].transpose();
    const Eigen::MatrixXd P = Q.ldlt().solve(Eigen::MatrixXd::Identity(A.rows(), A.rows()));
    const Eigen::MatrixXd PA = P * A;
    const Eigen::MatrixXd M = P - PA * (A.transpose() * PA).ldlt().solve(PA.transpose());
    const Eigen::VectorXd Mv = M * readings.residuals;
    Eigen::VectorXd slopes(static_cast<Eigen::Index>(readings.shares.size()));
    for (Eigen::Index k = 0; k < slopes.size(); ++k) {
        const Eigen::MatrixXd& B = readings.shares[static_cast<std::size_t>(k)];
        const double trace = (B.transpose() * M).cwiseProduct(B.transpose()).sum();
        slopes[k] = (B.transpose() * Mv).squaredNorm() / trace - 1.0;
    }
    return slopes;
}

}  // namespace covaria::campaigns_test
