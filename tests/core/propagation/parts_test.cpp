// Parts of the engine: ranks, numerical tolerance, factors of correlation matrices, sorting, verdicts.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/propagation/adaptive.h"
#include "core/propagation/draw_plan.h"
#include "core/propagation/normality.h"
#include "core/propagation/numerical_tolerance.h"
#include "core/propagation/order_statistics.h"
#include "core/propagation/sorting.h"
#include "core/random/uniforms.h"

namespace covaria::detail::parts_test {
namespace {

TEST(CoverageRanks, FollowJcgm101) {
    const CoverageRanks ranks = coverage_ranks(100'000, 0.95);  // 0.95 * 100000 is not exact in binary
    EXPECT_EQ(ranks.q, 95'000u);
    EXPECT_EQ(ranks.r, 2'500u);
    EXPECT_EQ(coverage_ranks(100'000'000, 0.95).q, 95'000'000u);
    EXPECT_EQ(coverage_ranks(11, 0.95).q, 10u);  // 10.45 -> floor(10.95)
    EXPECT_EQ(coverage_ranks(11, 0.95).r, 1u);
    EXPECT_EQ(coverage_ranks(13, 0.5).q, 7u);  // 6.5 -> 7
    EXPECT_EQ(coverage_ranks(13, 0.5).r, 3u);
    EXPECT_EQ(coverage_ranks(10, 0.5).r, 3u);  // (10 - 5)/2 is no integer -> floor(6/2)
    EXPECT_EQ(coverage_ranks(2, 0.999).q, 1u);
}

TEST(NumericalTolerance, FollowsJcgm101) {
    EXPECT_DOUBLE_EQ(numerical_tolerance(2.0, 2), 0.05);
    EXPECT_DOUBLE_EQ(numerical_tolerance(35.8, 2), 0.5);
    EXPECT_DOUBLE_EQ(numerical_tolerance(0.0754, 1), 0.005);
    EXPECT_DOUBLE_EQ(numerical_tolerance(0.0996, 2), 0.005);  // 10 * 10^-2
    EXPECT_DOUBLE_EQ(numerical_tolerance(0.001, 1), 0.0005);
    EXPECT_DOUBLE_EQ(numerical_tolerance(1000, 3), 5);
    EXPECT_EQ(numerical_tolerance(0, 2), 0.0);
    // 8.79e-4 rad is 0.050 deg: the last of its two digits is a thousandth of a degree.
    const Unit degree = Unit::of("deg");
    EXPECT_DOUBLE_EQ(degree.interval_from_si(numerical_tolerance(8.79e-4, degree, 2)), 0.0005);
}

TEST(Adaptive, BatchesOfWholeBlocks) {
    EXPECT_EQ(AdaptiveProcedure::batch_trials(0.95), 10'000u);
    EXPECT_EQ(AdaptiveProcedure::batch_trials(0.99), 10'000u);
    EXPECT_EQ(AdaptiveProcedure::batch_trials(0.999), 100'000u);
}

TEST(CorrelationFactor, ReproducesSemidefiniteMatrices) {
    Eigen::Matrix3d full;
    full << 1, 0.5, -0.3, 0.5, 1, 0.2, -0.3, 0.2, 1;
    Eigen::MatrixXd f = correlation_factor(full);
    EXPECT_EQ(f.cols(), 3);
    EXPECT_LT((f * f.transpose() - full).cwiseAbs().maxCoeff(), 1e-14);
    Eigen::Matrix3d rank_one;
    rank_one << 1, -1, 1, -1, 1, -1, 1, -1, 1;
    f = correlation_factor(rank_one);
    EXPECT_EQ(f.cols(), 1);
    EXPECT_EQ(f * f.transpose(), rank_one);
}

TEST(CorrelatedSets, AreConnectedComponents) {
    const auto sets = correlated_sets(6, {{4, 1, 0.1}, {1, 5, 0.2}, {0, 2, 0.0}});
    ASSERT_EQ(sets.size(), 1u);
    EXPECT_EQ(sets[0], (std::vector<std::size_t>{1, 4, 5}));
}

TEST(Sorting, AgreesWithTheLibrary) {
    for (std::size_t n : {0u, 1u, 100u, 5000u, 60'000u}) {
        std::vector<double> values(n);
        uniforms(5, DrawPurpose::trials, 1, 0, values);
        for (int shape = 0; shape < 4; ++shape) {
            std::vector<double> v = values;
            for (double& x : v) {
                if (shape == 1) x -= 0.5;                         // both signs
                if (shape == 2) x = 1 / (x - 0.5);                // heavy tails
                if (shape == 3) x = std::floor(10 * x) * 1e-300;  // ties, tiny
            }
            std::vector<double> expected = v;
            std::sort(expected.begin(), expected.end(), std::greater<>());
            sort_descending(v);
            EXPECT_EQ(v, expected) << n << " " << shape;
        }
    }
}

TEST(Normality, SpeaksInWords) {
    MonteCarloOutput output;
    output.standard_uncertainty = 1;
    const auto words = [&](double low, double high, double kurtosis) {
        output.symmetric = {low, high};
        output.kurtosis = kurtosis;
        return normality_of(output, 1'000'000, 0.95);
    };
    EXPECT_EQ(words(-1.96, 1.96, 0).words, "normal within 1 %");
    EXPECT_FALSE(words(-1.65, 1.65, -1.2).acceptable);  // rectangular
    EXPECT_NE(words(-1.65, 1.65, -1.2).words.english().find("flat"), std::string::npos);
    EXPECT_NE(words(-1.0, 2.7, 6).words.english().find("skewed"), std::string::npos);
    EXPECT_NE(words(-1.7, 1.7, 9).words.english().find("heavy"), std::string::npos);
    EXPECT_EQ(words(-1.9, 1.9, 0).words, "normal within 5 %");
}

}  // namespace
}  // namespace covaria::detail::parts_test
