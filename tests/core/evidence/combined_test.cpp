// A figure that several campaigns have seen: against an independent computation, and over simulated
// campaigns.
#include "core/evidence/combined.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace covaria::combined_test {
namespace {

using evidence::combined;
using evidence::CombinedFigure;

TEST(Combined, OneCampaignIsItsOwnResult) {
    const CombinedFigure one = combined({{0.7, 12.5}});
    EXPECT_EQ(one.u, 0.7);
    EXPECT_EQ(one.degrees_of_freedom, 12.5);
    EXPECT_EQ(one.between, 0.0);
}

/// Digamma and trigamma by their asymptotic series and roots by halving, in Python.
TEST(Combined, IsTheIndependentComputation) {
    const auto expect = [](const CombinedFigure& found, double u, double nu, double between) {
        EXPECT_NEAR(found.u, u, 1e-9 * u);
        EXPECT_NEAR(found.degrees_of_freedom, nu, 1e-9 * nu);
        EXPECT_NEAR(found.between, between, 1e-9);
    };
    expect(combined({{1.0, 20.0}, {1.0, 20.0}}), 1.01257334148, 39.0262255697, 0.0);
    expect(combined({{1.0, 20.0}, {2.5, 30.0}}), 1.10883034199, 1.56274360328, 0.624676237497);
    expect(combined({{0.3, 12.0}, {0.5, 25.0}, {0.45, 60.0}}), 0.415723232833, 11.8043235494, 0.171455331681);
    expect(combined({{1.0, 15.0}, {1.1, 40.0}}), 1.0822865455, 54.0259392944, 0.0);
}

/// With campaigns of one size Paule and Mandel's estimate is the variance of the logarithms less what each
/// scatters by itself, and unbiased.
TEST(Combined, FindsWhatCampaignsDifferBy) {
    std::mt19937_64 random(7);
    constexpr double nu = 15.0, between = 0.3;
    constexpr int campaigns = 8, times = 2000;
    std::normal_distribution<double> normal(0.0, between);
    std::chi_squared_distribution<double> chi(nu);
    double sum = 0.0, squares = 0.0;
    for (int k = 0; k < times; ++k) {
        std::vector<evidence::CampaignFigure> figures;
        for (int c = 0; c < campaigns; ++c)
            figures.push_back({std::exp(normal(random)) * std::sqrt(chi(random) / nu), nu});
        const double found = std::pow(combined(figures).between, 2);
        sum += found / times;
        squares += found * found / times;
    }
    EXPECT_NEAR(sum, between * between, 4.0 * std::sqrt((squares - sum * sum) / times));
}

}  // namespace
}  // namespace covaria::combined_test
