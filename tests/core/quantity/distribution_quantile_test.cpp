// Quantiles of blocks: accuracy, order, independence of blocking, no use of the heap.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/poisson.hpp>
#include <boost/math/distributions/weibull.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "allocation_count.h"
#include "core/math/normal_quantile.h"
#include "core/math/special_quantiles.h"
#include "distribution_cases.h"

namespace covaria::distribution_quantile_test {
namespace {

std::vector<double> extremes_and_uniforms(std::size_t count) {
    std::mt19937_64 generator(11);
    std::vector<double> p;
    for (int k = 53; k >= 2; --k) {
        p.push_back(std::ldexp(1.0, -k));
        p.push_back(1.0 - std::ldexp(1.0, -k));
    }
    while (p.size() < count) p.push_back((static_cast<double>(generator() >> 12) + 0.5) * 0x1p-52);
    std::shuffle(p.begin(), p.end(), generator);
    return p;
}

std::vector<Distribution> all_cases() {
    std::vector<Distribution> cases = distribution_cases();
    for (const Distribution& stepped : stepped_cases()) cases.push_back(stepped);
    return cases;
}

TEST(DistributionQuantiles, AreMonotoneAndFiniteToTheExtremes) {
    std::vector<double> p = extremes_and_uniforms(4000);
    std::sort(p.begin(), p.end());
    for (const Distribution& distribution : all_cases()) {
        SCOPED_TRACE(described(distribution));
        std::vector<double> x(p.size());
        distribution.quantiles(p, x);
        EXPECT_LT(x.front(), x.back());
        for (std::size_t i = 0; i < x.size(); ++i) {
            ASSERT_TRUE(std::isfinite(x[i])) << p[i];
            EXPECT_GE(x[i], x[i > 0 ? i - 1 : 0] - 2e-11 * std::abs(x[i])) << p[i];
        }
    }
}

TEST(DistributionQuantiles, StayInsideTheLimits) {
    const std::vector<double> p = extremes_and_uniforms(2000);
    for (const DistributionParameters& parameters : std::vector<DistributionParameters>{
             Rectangular{0.1, 0.3}, Trapezoidal{0.1, 0.3, 0.7}, Triangular{0.1, 0.3}, Arcsine{0.1, 0.3},
             TruncatedNormal{0.0, 7.0, 0.1, 0.3}, Beta{0.1, 0.3, 0.2, 0.1}}) {
        const Distribution distribution = Distribution::of(parameters);
        std::vector<double> x(p.size());
        distribution.quantiles(p, x);
        EXPECT_GE(*std::min_element(x.begin(), x.end()), 0.1) << described(distribution);
        EXPECT_LE(*std::max_element(x.begin(), x.end()), 0.3) << described(distribution);
    }
}

TEST(DistributionQuantiles, ElementsDoNotDependOnBlocking) {
    const std::vector<double> p = extremes_and_uniforms(1031);
    std::vector<double> z(p.size());
    normal_quantiles(p, z);
    for (const Distribution& distribution : all_cases()) {
        SCOPED_TRACE(described(distribution));
        std::vector<double> whole(p.size()), whole_of_scores(p.size());
        distribution.quantiles(p, whole);
        distribution.from_standard_normal(z, whole_of_scores);
        for (const std::size_t block : {1, 3, 5, 64, 1000}) {
            std::vector<double> parts = p, parts_of_scores = z;  // in place
            for (std::size_t begin = 0; begin < p.size(); begin += block) {
                const std::size_t length = std::min(block, p.size() - begin);
                const std::span<double> part(parts.data() + begin, length);
                const std::span<double> scores(parts_of_scores.data() + begin, length);
                distribution.quantiles(part, part);
                distribution.from_standard_normal(scores, scores);
            }
            EXPECT_EQ(parts, whole) << block;
            EXPECT_EQ(parts_of_scores, whole_of_scores) << block;
        }
        EXPECT_EQ(distribution.quantile(p[17]), whole[17]);
    }
}

TEST(DistributionQuantiles, OfScoresAreThoseOfTheirProbabilities) {
    for (const Distribution& distribution : distribution_cases()) {
        SCOPED_TRACE(described(distribution));
        for (const double z : {-4.0, -1.3, -0.2, 0.0, 0.7, 2.5}) {
            double x = z;
            distribution.from_standard_normal({&x, 1}, {&x, 1});
            const double expected = distribution.quantile(normal_distribution_function(z));
            EXPECT_NEAR(x, expected, 1e-9 * (std::abs(expected) + 1e-3)) << z;
        }
        for (const double z : {-40.0, -9.0, 9.0, 40.0}) {
            if (std::abs(z) > 10.0 && !std::isfinite(distribution.standard_deviation())) continue;
            double x = z;
            distribution.from_standard_normal({&x, 1}, {&x, 1});
            EXPECT_FALSE(std::isnan(x)) << z;
        }
    }
}

TEST(DistributionQuantiles, UseNoHeap) {
    const std::vector<double> p = extremes_and_uniforms(1024);
    std::vector<double> x(p.size());
    for (const Distribution& distribution : all_cases()) {
        const std::size_t before = allocation_count();
        distribution.quantiles(p, x);
        distribution.from_standard_normal(p, x);
        EXPECT_EQ(allocation_count(), before) << described(distribution);
    }
    const std::size_t before = allocation_count();
    std::vector<double> counted(3);
    EXPECT_EQ(allocation_count(), before + 1);  // the counter counts
}

TEST(DistributionQuantiles, StudentTAgreesWithBoost) {
    const std::vector<double> p = extremes_and_uniforms(1500);
    for (const double nu : {0.3, 0.5, 1.0, 1.7, 2.0, 4.0, 9.0, 33.3, 1e3, 1e7}) {
        const Distribution distribution = Distribution::of(StudentT{0.0, 1.0, nu});
        double worst = 0.0;
        for (const double probability : p) {
            if (std::abs(probability - 0.5) < 0.02) continue;  // Boost cancels there; see the next test
            const double expected = t_quantile(probability, nu);
            worst = std::max(worst, std::abs(distribution.quantile(probability) / expected - 1.0));
        }
        EXPECT_LT(worst, 5e-11) << nu;
        EXPECT_EQ(distribution.quantile(0.5), 0.0);
        EXPECT_NEAR(distribution.quantile(1e-30) / t_quantile(1e-30, nu), 1.0, 1e-10)
            << nu;  // beyond the table
    }
}

TEST(DistributionQuantiles, StudentTKeepsItsDigitsAtTheCentre) {
    for (const double d : {1e-7, 1e-5, 1e-3, 0.01, 0.1}) {  // closed forms for 1 and 2 degrees of freedom
        const double p = 0.5 + d;
        const double offset = p - 0.5;  // rounded as the quantile gets it
        EXPECT_NEAR(
            Distribution::of(StudentT{0.0, 1.0, 1.0}).quantile(p) / std::tan(std::numbers::pi * offset), 1.0,
            1e-10);
        const double of_two = offset * std::sqrt(8.0 / (1.0 - 4.0 * offset * offset));
        EXPECT_NEAR(Distribution::of(StudentT{0.0, 1.0, 2.0}).quantile(p) / of_two, 1.0, 1e-10);
    }
    const Distribution of_four = Distribution::of(StudentT{0.0, 1.0, 4.0});  // density at 0: 3/8
    EXPECT_NEAR(of_four.quantile(0.5 + 1e-6) / (1e-6 * 8.0 / 3.0), 1.0, 2e-10);
}

TEST(DistributionQuantiles, GammaAndBetaAgreeWithBoost) {
    const std::vector<double> p = extremes_and_uniforms(800);
    for (const double shape : {0.05, 0.5, 1.0, 5.0, 300.0}) {
        const Distribution gamma = Distribution::of(Gamma{shape, 2.0});
        const boost::math::gamma_distribution<double> reference(shape, 2.0);
        for (const double probability : p) {
            const double expected = quantile(reference, probability);
            EXPECT_NEAR(gamma.quantile(probability), expected, 5e-10 * expected + 1e-300)
                << shape << ' ' << probability;
        }
    }
    for (const auto& [a, b] : {std::pair{2.0, 5.0}, {0.5, 0.5}, {1.0, 1.0}, {40.0, 3.0}}) {
        const Distribution beta = Distribution::of(Beta{0.0, 1.0, a, b});
        const boost::math::beta_distribution<double> reference(a, b);
        for (const double probability : p)
            EXPECT_NEAR(beta.quantile(probability), quantile(reference, probability), 1e-10)
                << a << ' ' << probability;
    }
}

TEST(DistributionQuantiles, CurvilinearTrapezoidIsTheMixtureOfItsDefinition) {
    // JCGM 101 6.4.3.4: lower limit a rectangular on c +- d, the other limit opposite; average over it of the
    // rectangular distribution functions.
    for (const double d : {1e-4, 0.1, 0.4, 0.999, 1.0}) {
        const Distribution distribution = Distribution::of(CurvilinearTrapezoid{-1.0, 1.0, d});
        for (const double p : {1e-9, 1e-4, 0.01, 0.1, 0.3, 0.4999, 0.5, 0.8, 0.9999}) {
            const double x = distribution.quantile(p);
            constexpr int count = 200000;
            double sum = 0.0;
            for (int i = 0; i < count; ++i) {
                const double half = 1.0 + d * (2.0 * (i + 0.5) / count - 1.0);
                sum += std::clamp(0.5 * (x + half) / half, 0.0, 1.0);
            }
            EXPECT_NEAR(sum / count, p, 1e-9 + 1e-5 * std::min(p, 1.0 - p)) << d;
        }
        EXPECT_NEAR(distribution.quantile(0.5), 0.0, 1e-14);
    }
}

TEST(DistributionQuantiles, DiscreteTakesTheSmallestValueThatReachesP) {
    const Distribution d = discrete_case();
    EXPECT_EQ(d.quantile(0.01), 1.0);
    EXPECT_EQ(d.quantile(0.4), 1.0);
    EXPECT_EQ(d.quantile(0.41), 2.0);
    EXPECT_EQ(d.quantile(0.75), 4.0);
    EXPECT_EQ(d.quantile(0.95), 8.0);
    EXPECT_EQ(d.quantile(1.0 - 0x1p-53), 8.0);
}

TEST(DistributionQuantiles, WeibullAndLaplaceAgreeWithTheirDistributionFunctions) {
    const std::vector<double> p = extremes_and_uniforms(800);
    for (const double shape : {0.1, 0.5, 1.0, 1.5, 3.6, 40.0, 1e6}) {
        const Distribution weibull = Distribution::of(Weibull{0.0, 2.0, shape});
        const Distribution mirrored = Distribution::of(Weibull{0.0, -2.0, shape});
        const boost::math::weibull_distribution<double> reference(shape, 2.0);
        for (const double probability : p) {
            const double expected = quantile(reference, probability);
            EXPECT_NEAR(weibull.quantile(probability), expected, 1e-13 * (1.0 + 40.0 / shape) * expected)
                << shape << ' ' << probability;
            EXPECT_NEAR(mirrored.quantile(1.0 - probability), -expected, 1e-8 * expected)
                << shape << ' ' << probability;
        }
    }
    const Distribution laplace = Distribution::of(Laplace{0.0, 3.0});
    for (const double probability : p) {
        const double low = std::min(probability, 1.0 - probability);
        const double expected = 3.0 * std::log(2.0 * low);
        EXPECT_NEAR(laplace.quantile(probability), probability < 0.5 ? expected : -expected,
                    1e-15 * std::abs(expected) + 1e-300);
    }
    EXPECT_EQ(laplace.quantile(0.5), 0.0);
}

/// The smallest number whose distribution function reaches p, for means from a thousandth to ten millions.
TEST(DistributionQuantiles, NumbersOfEventsAreThoseOfBoost) {
    const std::vector<double> p = extremes_and_uniforms(400);
    const auto check = [&](const Distribution& distribution, const auto& reference) {
        for (const double probability : p) {
            const double n = distribution.quantile(probability);
            EXPECT_EQ(n, std::round(n));
            const double slack = 2e-11 * probability + 1e-15;
            EXPECT_GE(cdf(reference, n) + slack, probability) << described(distribution);
            if (n > 0.0) {
                EXPECT_LE(cdf(reference, n - 1.0) - slack, probability) << described(distribution);
            }
        }
    };
    for (const double number : {1e-3, 0.5, 3.0, 45.5, 1e3, 1e5, 1e7})
        check(Distribution::of(Poisson{number, 1.0, 0.0}), boost::math::poisson_distribution<double>(number));
    for (const double trials : {1.0, 7.0, 300.0, 1e5, 1e7})
        for (const double probability : {1e-6, 0.02, 0.5, 0.999})
            check(Distribution::of(Binomial{trials, probability, 1.0, 0.0}),
                  boost::math::binomial_distribution<double>(trials, probability));
}

TEST(DistributionQuantiles, ZeroWidthsAreConstants) {
    for (const DistributionParameters& parameters : std::vector<DistributionParameters>{
             Normal{2.0, 0.0}, StudentT{2.0, 0.0, 3.0}, Rectangular{2.0, 2.0},
             CurvilinearTrapezoid{2.0, 2.0, 0.0}, Trapezoidal{2.0, 2.0, 0.4}, Triangular{2.0, 2.0},
             Arcsine{2.0, 2.0}, TruncatedNormal{2.0, 0.0, 1.0, 3.0}, TruncatedNormal{5.0, 1.0, 2.0, 2.0},
             Lognormal{std::log(2.0), 0.0}, Beta{2.0, 2.0, 2.0, 3.0}, Discrete{{2.0}, {1.0}},
             Laplace{2.0, 0.0}, Weibull{2.0, 0.0, 1.5}, Poisson{0.0, 1.0, 2.0}, Poisson{5.0, 0.0, 2.0},
             Binomial{3.0, 0.0, 1.0, 2.0}, Binomial{2.0, 1.0, 1.0, 0.0}, Binomial{0.0, 0.5, 1.0, 2.0}}) {
        const Distribution distribution = Distribution::of(parameters);
        SCOPED_TRACE(described(distribution));
        EXPECT_EQ(distribution.standard_deviation(), 0.0);
        EXPECT_DOUBLE_EQ(distribution.mean(), 2.0);
        for (const double p : {0x1p-53, 0.3, 1.0 - 0x1p-53}) EXPECT_DOUBLE_EQ(distribution.quantile(p), 2.0);
    }
    for (const DistributionParameters& parameters :
         std::vector<DistributionParameters>{Exponential{0.0}, Gamma{2.0, 0.0}})
        EXPECT_EQ(Distribution::of(parameters).quantile(0.999), 0.0);
    EXPECT_EQ(Distribution().quantile(0.7), 0.0);
}

TEST(DistributionQuantiles, FollowScalingAndShifting) {
    for (const Distribution& distribution : all_cases()) {
        SCOPED_TRACE(described(distribution));
        for (const double c : {2.5, -0.5, -1.0}) {
            const Distribution changed = distribution.scaled(c).shifted(3.0).scaled(2.0).shifted(-1.0);
            for (const double p : {0.0103, 0.205, 0.701, 0.9907}) {
                const double x = distribution.quantile(c > 0.0 ? p : 1.0 - p);
                EXPECT_NEAR(changed.quantile(p), 2.0 * (c * x + 3.0) - 1.0, 1e-9 * (1.0 + std::abs(x))) << c;
            }
            EXPECT_NEAR(changed.mean(), 2.0 * (c * distribution.mean() + 3.0) - 1.0,
                        1e-12 * (1.0 + std::abs(changed.mean())));
            if (std::isfinite(distribution.standard_deviation())) {
                EXPECT_NEAR(changed.standard_deviation(),
                            2.0 * std::abs(c) * distribution.standard_deviation(), 1e-12);
            }
        }
        EXPECT_EQ(distribution.scaled(0.0).quantile(0.9), 0.0);
        EXPECT_EQ(distribution.scaled(1.0).shifted(0.0), distribution);
        EXPECT_NE(distribution.shifted(1.0), distribution);
    }
}

}  // namespace
}  // namespace covaria::distribution_quantile_test
