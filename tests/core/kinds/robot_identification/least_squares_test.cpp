// Statistics of what a fit leaves over, against the formulas with whole matrices.
#include "core/kinds/robot_identification/least_squares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace covaria::identification {
namespace {

struct Fit {
    Eigen::MatrixXd design, from_inputs, V;
    Eigen::VectorXd residuals;
};

/// Rows that share some inputs; columns of the design of very different sizes. The residuals are those of the
/// best fit by the weights of each row alone.
Fit fit_of(Eigen::Index rows, Eigen::Index unknowns, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto any = [&](Eigen::Index n, Eigen::Index m) {
        Eigen::MatrixXd made(n, m);
        for (double& x : made.reshaped()) x = normal(random);
        return made;
    };
    Fit fit;
    fit.design = any(rows, unknowns);
    for (Eigen::Index k = 0; k < unknowns; ++k) fit.design.col(k) *= std::pow(10.0, double(k % 7) - 3.0);
    fit.from_inputs.resize(rows, rows + 5);
    fit.from_inputs.leftCols(rows) =
        Eigen::VectorXd(any(rows, 1).cwiseAbs() + Eigen::VectorXd::Constant(rows, 0.3)).asDiagonal();
    fit.from_inputs.rightCols(5) = 0.4 * any(rows, 5);
    fit.V = fit.from_inputs * fit.from_inputs.transpose();
    const Eigen::VectorXd l = fit.from_inputs * any(rows + 5, 1), p = fit.V.diagonal().cwiseInverse();
    const Eigen::MatrixXd N = fit.design.transpose() * p.asDiagonal() * fit.design;
    const Eigen::VectorXd x = N.fullPivLu().solve(fit.design.transpose() * p.asDiagonal() * l);
    fit.residuals = l - fit.design * x;
    return fit;
}

TEST(FitStatistics, ByTheCovarianceOfAllRowsAreBaardasTests) {
    for (const auto& [rows, unknowns, seed] :
         {std::tuple(40, 3, 1u), std::tuple(41, 6, 2u), std::tuple(223, 22, 3u), std::tuple(97, 17, 4u)}) {
        const Fit fit = fit_of(rows, unknowns, seed);
        const Eigen::VectorXd w = fit.V.diagonal().cwiseSqrt().cwiseInverse();
        const auto gain = gain_of(Eigen::MatrixXd(w.asDiagonal() * fit.design), w);
        ASSERT_TRUE(gain);
        FitStatistics found;
        take_statistics(found, *gain, fit.residuals, fit.design, fit.from_inputs, w, TestBy::covariance);
        // v of the best fit by the whole covariance; w_i = |(V⁻¹v)_i| / root of (V⁻¹ Q_vv V⁻¹)_ii
        const Eigen::MatrixXd S = fit.design * fit.design.colwise().norm().eval().cwiseInverse().asDiagonal();
        const Eigen::MatrixXd P = fit.V.llt().solve(Eigen::MatrixXd::Identity(rows, rows));
        const Eigen::MatrixXd PS = P * S;
        const Eigen::MatrixXd R = P - PS * (S.transpose() * PS).llt().solve(PS.transpose());
        const Eigen::VectorXd Rr = R * fit.residuals;
        EXPECT_NEAR(found.scatter, std::sqrt(fit.residuals.dot(Rr) / (rows - unknowns)), 1e-9);
        ASSERT_EQ(found.w.size(), rows);
        for (Eigen::Index i = 0; i < rows; ++i)
            EXPECT_NEAR(found.w[i], std::abs(Rr[i]) / std::sqrt(R(i, i)), 1e-8) << i;
    }
}

TEST(FitStatistics, ByTheirOwnScatterAreResidualsOverTheirUncertainty) {
    const Fit fit = fit_of(50, 5, 5u);
    const Eigen::VectorXd w = fit.V.diagonal().cwiseSqrt().cwiseInverse();
    const auto gain = gain_of(Eigen::MatrixXd(w.asDiagonal() * fit.design), w);
    ASSERT_TRUE(gain);
    FitStatistics found;
    take_statistics(found, *gain, fit.residuals, fit.design, fit.from_inputs, w, TestBy::scatter);
    const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(50, 50) - fit.design * gain->gain;
    const Eigen::MatrixXd Q = M * fit.V * M.transpose();
    for (Eigen::Index i = 0; i < 50; ++i)
        EXPECT_NEAR(found.w[i], std::abs(fit.residuals[i]) / std::sqrt(Q(i, i)), 1e-8) << i;
}

}  // namespace
}  // namespace covaria::identification
