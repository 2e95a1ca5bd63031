// Variance components: against dense matrices, over simulated campaigns, and where nothing can be told.
#include "core/evidence/seen.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/adjustment/adjustment.h"

namespace covaria::seen_test {
namespace {

using evidence::RedundantReadings;
using evidence::Seen;
using evidence::SeenFigure;
using evidence::Verdict;

/// Readings of two kinds of unknowns that are all determined.
struct Campaign {
    Eigen::MatrixXd design;
    Eigen::VectorXd u;  ///< stated uncertainties
    std::vector<std::size_t> figure_of;

    RedundantReadings readings(const Eigen::VectorXd& errors) const {
        RedundantReadings made;
        made.design = design.sparseView();
        made.whitening = adjustment::whitening(u, {});
        const Eigen::MatrixXd P = u.cwiseAbs2().cwiseInverse().asDiagonal();
        const Eigen::VectorXd x =
            (design.transpose() * P * design).ldlt().solve(design.transpose() * P * errors);
        made.residuals = errors - design * x;
        made.figure_of = figure_of;
        for (std::size_t i = 0; i < static_cast<std::size_t>(design.cols()); ++i)
            made.measurands.push_back(i);
        for (const std::size_t k : figure_of)
            if (k != RedundantReadings::no_figure) made.figures.resize(std::max(made.figures.size(), k + 1));
        return made;
    }
};

/// `sizes[k]` readings of figure k, with a design of random numbers.
Campaign campaign(const std::vector<int>& sizes, int unknowns, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Campaign made;
    int m = 0;
    for (const int size : sizes) m += size;
    made.design.resize(m, unknowns);
    for (double& d : made.design.reshaped()) d = normal(random);
    made.u.resize(m);
    for (double& u : made.u) u = std::exp(0.4 * normal(random));
    for (std::size_t k = 0; k < sizes.size(); ++k)
        made.figure_of.insert(made.figure_of.end(), static_cast<std::size_t>(sizes[k]), k);
    return made;
}

Eigen::VectorXd errors(const Campaign& of, const std::vector<double>& factors, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    Eigen::VectorXd e(of.u.size());
    for (Eigen::Index i = 0; i < e.size(); ++i)
        e[i] = factors[of.figure_of[static_cast<std::size_t>(i)]] * of.u[i] * normal(random);
    return e;
}

/// One solution of N s = l at the components `square`, straight from the formula.
struct DenseStep {
    Eigen::VectorXd square, u;
};
DenseStep dense_step(const Campaign& of, const Eigen::VectorXd& e, const Eigen::VectorXd& square) {
    const Eigen::Index m = e.size(), n = square.size();
    std::vector<Eigen::MatrixXd> Q(static_cast<std::size_t>(n), Eigen::MatrixXd::Zero(m, m));
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(m, m);
    for (Eigen::Index i = 0; i < m; ++i) {
        const std::size_t k = of.figure_of[static_cast<std::size_t>(i)];
        Q[k](i, i) = of.u[i] * of.u[i];
        whole(i, i) = square[static_cast<Eigen::Index>(k)] * Q[k](i, i);
    }
    const Eigen::MatrixXd P = whole.inverse(), A = of.design;
    const Eigen::MatrixXd R =
        Eigen::MatrixXd::Identity(m, m) - A * (A.transpose() * P * A).inverse() * A.transpose() * P;
    const Eigen::VectorXd v = R * e;
    Eigen::MatrixXd N(n, n);
    Eigen::VectorXd l(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::MatrixXd& of_k = Q[static_cast<std::size_t>(k)];
        l[k] = 0.5 * v.dot(P * of_k * P * v);
        for (Eigen::Index j = 0; j < n; ++j)
            N(k, j) = 0.5 * (P * R * of_k * P * R * Q[static_cast<std::size_t>(j)]).trace();
    }
    return {N.ldlt().solve(l), N.inverse().diagonal().cwiseSqrt()};
}

TEST(Seen, IsTheSolutionOfTheDenseEquations) {
    const Campaign of = campaign({12, 25, 18}, 7, 3);
    std::mt19937_64 random(17);
    const Eigen::VectorXd e = errors(of, {0.4, 1.0, 2.5}, random);
    const Seen seen = evidence::see(of.readings(e));
    ASSERT_TRUE(seen.found);
    DenseStep step{Eigen::VectorXd::Ones(3), {}};
    for (int round = 0; round < 60; ++round) step = dense_step(of, e, step.square);
    double redundancy = 0.0;
    for (Eigen::Index k = 0; k < 3; ++k) {
        const SeenFigure& figure = seen.figures[static_cast<std::size_t>(k)];
        EXPECT_NEAR(figure.square, step.square[k], 1e-8 * step.square[k]);
        EXPECT_NEAR(figure.u_square, step.u[k], 1e-8 * step.u[k]);
        redundancy += figure.redundancy;
    }
    EXPECT_NEAR(redundancy, seen.degrees_of_freedom, 1e-9);
    EXPECT_EQ(seen.degrees_of_freedom, 48);
    EXPECT_EQ(seen.figures[0].verdict, Verdict::too_little);  // redundancy below 10
    EXPECT_EQ(seen.figures[2].verdict, Verdict::larger);
}

/// The same campaign, with what makes its readings uncertain as components.
RedundantReadings together(const Campaign& of, const Eigen::VectorXd& e, std::size_t figures) {
    RedundantReadings readings = of.readings(e);
    readings.whitening = {};
    for (std::size_t k = 0; k < figures; ++k) {
        std::vector<Eigen::Index> own;
        for (std::size_t i = 0; i < of.figure_of.size(); ++i)
            if (of.figure_of[i] == k) own.push_back(static_cast<Eigen::Index>(i));
        Eigen::MatrixXd B = Eigen::MatrixXd::Zero(e.size(), static_cast<Eigen::Index>(own.size()));
        for (std::size_t c = 0; c < own.size(); ++c) B(own[c], static_cast<Eigen::Index>(c)) = of.u[own[c]];
        readings.shares.push_back(B);
    }
    return readings;
}

TEST(Seen, IsTheSameWhereReadingsAreSaidToShareNothing) {
    const Campaign of = campaign({14, 25, 18}, 7, 3);
    std::mt19937_64 random(19);
    const Eigen::VectorXd e = errors(of, {0.4, 1.0, 2.5}, random);
    const Seen apart = evidence::see(of.readings(e)), one = evidence::see(together(of, e, 3));
    ASSERT_TRUE(apart.found && one.found);
    EXPECT_NEAR(apart.sum_of_squares, one.sum_of_squares, 1e-8 * one.sum_of_squares);
    EXPECT_EQ(apart.degrees_of_freedom, one.degrees_of_freedom);
    EXPECT_NEAR(apart.mean_u_seen, one.mean_u_seen, 1e-8 * one.mean_u_seen);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(apart.figures[k].square, one.figures[k].square, 1e-7 * one.figures[k].square);
        EXPECT_NEAR(apart.figures[k].u_square, one.figures[k].u_square, 1e-7 * one.figures[k].u_square);
        EXPECT_NEAR(apart.figures[k].redundancy, one.figures[k].redundancy, 1e-7);
    }
}

// A deviation that every reading of a group shares, and noise of its own.
TEST(Seen, TellsSharedDeviationsFromNoise) {
    std::mt19937_64 random(43);
    std::normal_distribution<double> normal;
    constexpr int groups = 30, each = 5, campaigns = 200;
    RedundantReadings readings;
    readings.design = Eigen::MatrixXd::Ones(groups * each, 1).sparseView();
    readings.figures.resize(2);
    readings.shares = {Eigen::MatrixXd::Identity(groups * each, groups * each),
                       Eigen::MatrixXd::Zero(groups * each, groups)};
    for (int i = 0; i < groups * each; ++i) readings.shares[1](i, i / each) = 1.0;
    double noise = 0.0, shared = 0.0;
    for (int c = 0; c < campaigns; ++c) {
        Eigen::VectorXd e(groups * each), of_group(groups);
        for (double& g : of_group) g = 2.0 * normal(random);
        for (int i = 0; i < e.size(); ++i) e[i] = 0.5 * normal(random) + of_group[i / each];
        readings.residuals = e;
        const Seen seen = evidence::see(readings);
        ASSERT_TRUE(seen.found);
        noise += seen.figures[0].square / campaigns;
        shared += seen.figures[1].square / campaigns;
    }
    // Standard deviations of the components by the analysis of variance of balanced groups.
    const double s_noise = 0.25 * std::sqrt(2.0 / (groups * (each - 1)) / campaigns);
    const double s_shared = (4.0 + 0.25 / each) * std::sqrt(2.0 / (groups - 1) / campaigns);
    EXPECT_NEAR(noise, 0.25, 4.0 * s_noise);
    EXPECT_NEAR(shared, 4.0, 4.0 * s_shared);
}

// One figure: the components are s0², with the u of chi-squared.
TEST(Seen, ManyReadingsOfFewUnknownsAreNoBurden) {
    const Campaign of = campaign({7000, 9000}, 5, 11);
    std::mt19937_64 random(23);
    const Seen seen = evidence::see(of.readings(errors(of, {0.5, 2.0}, random)));
    ASSERT_TRUE(seen.found);
    // Four standard uncertainties of a factor of so many degrees of freedom.
    EXPECT_NEAR(seen.figures[0].factor, 0.5, 4.0 * 0.5 / std::sqrt(2.0 * 7000));
    EXPECT_NEAR(seen.figures[1].factor, 2.0, 4.0 * 2.0 / std::sqrt(2.0 * 9000));
}

TEST(Seen, OneFigureIsSNought) {
    const Campaign of = campaign({30}, 6, 5);
    std::mt19937_64 random(2);
    const Seen seen = evidence::see(of.readings(errors(of, {3.0}, random)));
    ASSERT_TRUE(seen.found);
    EXPECT_NEAR(seen.figures[0].factor, seen.s0, 1e-10);
    EXPECT_NEAR(seen.figures[0].degrees_of_freedom, 24.0, 1e-8);
    EXPECT_NEAR(seen.figures[0].u_square, seen.figures[0].square * std::sqrt(2.0 / 24.0), 1e-10);
    EXPECT_NEAR(seen.mean_u_seen, seen.s0 * seen.mean_u_stated, 1e-10 * seen.mean_u_seen);
}

// Factors unbiased, intervals that cover, alarms at the level asked for: within four standard errors.
TEST(Seen, CoversOverFiveHundredCampaigns) {
    const Campaign of = campaign({40, 36}, 10, 11);
    const std::vector<double> truth{0.5, 1.0};
    std::mt19937_64 random(23);
    constexpr int campaigns = 500;
    std::vector<double> sum(2), squares(2);
    std::vector<int> covered(2);
    int alarms = 0;
    for (int c = 0; c < campaigns; ++c) {
        const Seen seen = evidence::see(of.readings(errors(of, truth, random)));
        ASSERT_TRUE(seen.found);
        for (std::size_t k = 0; k < 2; ++k) {
            const SeenFigure& figure = seen.figures[k];
            sum[k] += figure.square;
            squares[k] += figure.square * figure.square;
            covered[k] += figure.low <= truth[k] && truth[k] <= figure.high;
        }
        alarms += seen.figures[1].verdict != Verdict::agrees;
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const double mean = sum[k] / campaigns;
        const double s = std::sqrt((squares[k] - campaigns * mean * mean) / (campaigns - 1.0));
        EXPECT_NEAR(mean, truth[k] * truth[k], 4.0 * s / std::sqrt(campaigns)) << k;
        EXPECT_GE(covered[k], 0.93 * campaigns) << k;
        EXPECT_LE(covered[k], 0.97 * campaigns) << k;
    }
    EXPECT_NEAR(alarms, 0.05 * campaigns, 4.0 * std::sqrt(0.05 * 0.95 * campaigns));
}

// A difference of two readings tells what they have together, not which of them has it.
TEST(Seen, FiguresThatOneReadingEachBringsAreNotToldApart) {
    Campaign of;
    of.design = Eigen::MatrixXd::Ones(2, 1);
    of.u = Eigen::VectorXd::Ones(2);
    of.figure_of = {0, 1};
    const Seen seen = evidence::see(of.readings(Eigen::Vector2d(1.0, -2.0)));
    ASSERT_TRUE(seen.found);
    EXPECT_EQ(seen.figures[0].not_apart, std::vector<std::size_t>{1});
    EXPECT_EQ(seen.figures[1].not_apart, std::vector<std::size_t>{0});
    EXPECT_EQ(seen.figures[0].factor, seen.figures[1].factor);
    EXPECT_NEAR(seen.figures[0].factor, seen.s0, 1e-9);
    EXPECT_EQ(seen.figures[0].verdict, Verdict::too_little);
}

TEST(Seen, AComponentBelowZeroIsZeroAndSaid) {
    // Figure 1 has no scatter beside the unknowns that its few readings share with the rest.
    const Campaign of = campaign({40, 30}, 5, 29);
    std::mt19937_64 random(31);
    Eigen::VectorXd e = errors(of, {1.0, 0.0}, random);
    const Seen seen = evidence::see(of.readings(e));
    ASSERT_TRUE(seen.found);
    EXPECT_TRUE(seen.figures[1].clamped);
    EXPECT_EQ(seen.figures[1].factor, 0.0);
    EXPECT_EQ(seen.figures[1].verdict, Verdict::smaller);
    EXPECT_NEAR(seen.figures[0].factor, 1.0, 0.5);
}

TEST(Seen, WithoutRedundancyNothingIsSaid) {
    const Campaign of = campaign({4}, 4, 1);
    const Seen seen = evidence::see(of.readings(Eigen::VectorXd::Ones(4)));
    EXPECT_FALSE(seen.found);
    EXPECT_TRUE(seen.figures.empty());
}

// Readings that no figure is asked about keep the variance that they have.
TEST(Seen, ReadingsWithoutAFigureKeepTheirs) {
    Campaign of = campaign({40, 40}, 6, 37);
    std::mt19937_64 random(41);
    const Eigen::VectorXd e = errors(of, {2.0, 1.0}, random);
    for (std::size_t i = 40; i < 80; ++i) of.figure_of[i] = RedundantReadings::no_figure;
    const Seen seen = evidence::see(of.readings(e));
    ASSERT_TRUE(seen.found);
    ASSERT_EQ(seen.figures.size(), 1u);
    EXPECT_NEAR(seen.figures[0].factor, 2.0, 4.0 * 2.0 / std::sqrt(2.0 * seen.figures[0].redundancy));
    EXPECT_LT(seen.figures[0].redundancy, seen.degrees_of_freedom - 20.0);
}

}  // namespace
}  // namespace covaria::seen_test
