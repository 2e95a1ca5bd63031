// Distributions of sums against closed forms and against integrals.
#include "core/propagation/linear_distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/math/normal_quantile.h"
#include "core/math/special_quantiles.h"
#include "tests/core/quantity/distribution_cases.h"

namespace covaria::linear_distribution_test {
namespace {

using detail::LinearDistribution;
using detail::LinearTerm;

LinearTerm term(const Distribution& distribution, double factor = 1.0) {
    return {factor, distribution, std::make_shared<const CharacteristicFunction>(distribution)};
}

/// F(x) = mean of Phi((x - f(X - m))/sigma) over X.
double with_normal(const Distribution& distribution, double factor, double sigma, double x) {
    constexpr double step = 0.001, end = 9.0;
    std::vector<double> z, values;
    for (double score = -end; score <= end; score += step) z.push_back(score);
    values.resize(z.size());
    distribution.from_standard_normal(z, values);
    double sum = 0.0;
    for (std::size_t k = 0; k < z.size(); ++k)
        sum += step * normal_density(z[k]) *
               normal_distribution_function((x - factor * (values[k] - distribution.mean())) / sigma);
    return sum;
}

TEST(LinearDistribution, EveryKindWithANormalTerm) {
    for (const Distribution& distribution : distribution_cases()) {
        const double u = distribution.standard_deviation();
        if (u == 0.0) continue;
        const double width = std::isfinite(u) ? u : distribution.standard_uncertainty();
        const double sigma = 0.6, factor = -1.0 / width;
        const LinearDistribution sum(
            {term(distribution, factor), term(Distribution::normal(0.3), 2.0), term(Distribution(), 5.0)});
        EXPECT_DOUBLE_EQ(sum.standard_deviation(), std::hypot(u / width, sigma));
        const bool smooth = distribution.kind() != "discrete";
        for (const double x : {-3.0, -1.9, 0.0, 0.4, 2.2})
            EXPECT_NEAR(sum.distribution_function(x), with_normal(distribution, factor, sigma, x),
                        smooth ? 2e-8 : 1e-4)
                << distribution.title() << ", " << x;
        for (const double p : {0.025, 0.5, 0.975})
            EXPECT_NEAR(sum.distribution_function(*sum.quantile(p)), p, 1e-12) << distribution.title();
    }
}

/// Numbers of events with too little noise to hide the steps have no exact quantile, however many they are.
TEST(LinearDistribution, StepsAreNeverTakenForADensity) {
    for (const double number : {2.0, 400.0, 1e6}) {
        const Distribution events = Distribution::of(Poisson{number, 0.5, 0.0});
        EXPECT_FALSE(LinearDistribution({term(events)}).quantile(0.975)) << number;
        EXPECT_FALSE(LinearDistribution({term(events), term(Distribution::normal(0.05))}).quantile(0.975))
            << number;
        const LinearDistribution smooth({term(events), term(Distribution::normal(1.0))});
        ASSERT_TRUE(smooth.quantile(0.975)) << number;
        const double x = *smooth.quantile(0.975);
        const Discrete table = values_with_probabilities(events);
        double below = 0.0;
        for (std::size_t i = 0; i < table.values.size(); ++i)
            below +=
                table.probabilities[i] * normal_distribution_function(x - (table.values[i] - events.mean()));
        EXPECT_NEAR(below, 0.975, 1e-8) << number;
    }
}

/// The characteristic function of a thousand values falls as if there were a density.
TEST(LinearDistribution, ALongSampleAloneHasNoExactQuantile) {
    Discrete sample;
    for (int i = 0; i < 1000; ++i) {
        sample.values.push_back(std::fmod(0.7548776662466927 * i, 1.0));
        sample.probabilities.push_back(1e-3);
    }
    EXPECT_FALSE(LinearDistribution({term(Distribution::of(sample))}).quantile(0.975));
}

TEST(LinearDistribution, NormalTermsAndSingleTermsAreExact) {
    const LinearDistribution normal({term(Distribution::normal(3.0)), term(Distribution::normal(2.0), -2.0)});
    EXPECT_DOUBLE_EQ(*normal.quantile(0.975), 5.0 * normal_quantile(0.975));
    EXPECT_DOUBLE_EQ(normal.distribution_function(5.0), normal_distribution_function(1.0));
    const LinearDistribution t({term(Distribution::of(StudentT{4.0, 2.0, 3.0}), -3.0)});
    EXPECT_NEAR(*t.quantile(0.975), 6.0 * t_quantile(0.975, 3.0), 1e-9);
    EXPECT_DOUBLE_EQ(t.standard_deviation(), 6.0 * std::numbers::sqrt3);
    const LinearDistribution arcsine({term(Distribution::of(Arcsine{-1.0, 1.0}), 2.0)});
    EXPECT_NEAR(*arcsine.quantile(0.9), -2.0 * std::cos(0.9 * std::numbers::pi), 1e-14);
    EXPECT_NEAR(arcsine.distribution_function(1.0), 0.5 + std::asin(0.5) / std::numbers::pi, 1e-7);
    const LinearDistribution constant({});
    EXPECT_EQ(constant.distribution_function(0.1), 1.0);
    EXPECT_EQ(*constant.quantile(0.3), 0.0);
}

/// Irwin and Hall: the sum of n rectangular variables in [0, 1].
double irwin_hall(int n, double x) {
    double sum = 0.0, choose = 1.0, factorial = 1.0;
    for (int k = 0; k <= n; ++k) {
        if (x > k) sum += (k % 2 == 0 ? 1.0 : -1.0) * choose * std::pow(x - k, n);
        choose *= static_cast<double>(n - k) / (k + 1);
        if (k > 0) factorial *= k;
    }
    return sum / factorial;
}

TEST(LinearDistribution, SumsOfRectangularVariablesAreIrwinHall) {
    const Distribution unit = Distribution::of(Rectangular{0.0, 1.0});
    const std::vector<double> tolerances{0.0, 0.0, 1e-7, 1e-8, 1e-10, 1e-11, 1e-12};
    for (int n = 2; n <= 6; ++n) {
        const LinearDistribution sum(std::vector<LinearTerm>(static_cast<std::size_t>(n), term(unit)));
        for (const double part : {0.12, 0.3, 0.45, 0.61, 0.77, 0.9}) {
            const double x = part * n;
            EXPECT_NEAR(sum.distribution_function(x - 0.5 * n), irwin_hall(n, x),
                        tolerances[static_cast<std::size_t>(n)])
                << n << ", " << x;
        }
    }
}

TEST(LinearDistribution, SumsOfExponentialVariablesAreGamma) {
    const LinearDistribution sum(std::vector<LinearTerm>(4, term(Distribution::of(Exponential{1.0}), 3.0)));
    for (const double x : {-9.0, -4.0, 0.0, 5.0, 20.0})
        EXPECT_NEAR(sum.distribution_function(x), boost::math::gamma_p(4.0, (x + 12.0) / 3.0), 1e-8) << x;
    EXPECT_NEAR(boost::math::gamma_p(4.0, (*sum.quantile(0.975) + 12.0) / 3.0), 0.975, 1e-8);
}

/// Cauchy variables add their scales; heavier tails than these are refused.
TEST(LinearDistribution, HeavyTails) {
    const LinearDistribution cauchy({term(Distribution::of(StudentT{0.0, 1.0, 1.0})),
                                     term(Distribution::of(StudentT{3.0, 2.0, 1.0}), -1.0)});
    for (const double p : {0.025, 0.3, 0.5, 0.9, 0.975})
        EXPECT_NEAR(cauchy.distribution_function(3.0 * t_quantile(p, 1.0)), p, 1e-6) << p;
    EXPECT_EQ(cauchy.quantile(0.9999), std::nullopt);
    EXPECT_TRUE(std::isinf(cauchy.standard_deviation()));
    // Two t of three degrees of freedom: density (s = sqrt 3) from the product of their closed forms.
    const LinearDistribution three(
        std::vector<LinearTerm>(2, term(Distribution::of(StudentT{0.0, 1.0, 3.0}))));
    const auto exact = [](double x) {
        constexpr double step = 1e-4;
        double sum = 0.0;
        for (double t = 0.5 * step; t < 40.0; t += step) {
            const double s = std::numbers::sqrt3 * t, phi = (1.0 + s) * std::exp(-s);
            sum += step * std::sin(t * x) / t * phi * phi;
        }
        return 0.5 + sum / std::numbers::pi;
    };
    for (const double x : {-6.0, -2.0, 1.0, 4.5}) EXPECT_NEAR(three.distribution_function(x), exact(x), 1e-8);
}

/// P(X <= x) in closed form.
double exact_distribution_function(const Distribution& distribution, double x) {
    const auto within = [](double low, double high, double at) {
        return std::clamp((at - low) / (high - low), 0.0, 1.0);
    };
    const DistributionParameters& parameters = distribution.parameters();
    if (const auto* r = std::get_if<Rectangular>(&parameters)) return within(r->low, r->high, x);
    if (const auto* a = std::get_if<Arcsine>(&parameters))
        return 2.0 / std::numbers::pi * std::asin(std::sqrt(within(a->low, a->high, x)));
    if (const auto* b = std::get_if<Beta>(&parameters))
        return boost::math::ibeta(b->alpha, b->beta, within(b->low, b->high, x));
    if (const auto* g = std::get_if<Gamma>(&parameters))
        return x > 0.0 ? boost::math::gamma_p(g->shape, x / g->scale) : 0.0;
    if (const auto* l = std::get_if<Lognormal>(&parameters))
        return x > 0.0 ? normal_distribution_function((std::log(x) - l->log_mean) / l->log_standard_deviation)
                       : 0.0;
    const auto& t = std::get<StudentT>(parameters);
    return t_distribution_function((x - t.mean) / t.scale, t.degrees_of_freedom);
}

/// Distribution function of X - E X plus normal noise: mean over the noise, piece by piece between ends of X.
double exact_with_noise(const Distribution& distribution, double sigma, double x) {
    constexpr double end = 9.0;
    const double centre = x + distribution.mean();
    std::vector<double> edges{-end, end};
    for (const double p : {1e-300, 0.5, 1.0 - 1e-16}) {
        const double z = (centre - distribution.quantile(p)) / sigma;
        if (std::abs(z) < end) edges.push_back(z);
    }
    std::sort(edges.begin(), edges.end());
    boost::math::quadrature::tanh_sinh<double> integrator;
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < edges.size(); ++k)
        if (edges[k + 1] > edges[k])
            sum += integrator.integrate(
                [&](double z) {
                    return normal_density(z) * exact_distribution_function(distribution, centre - sigma * z);
                },
                edges[k], edges[k + 1], 1e-11);
    return sum;
}

/// The case that a shape and noise of any ratio make: where the grid, the damping or the quadrature of the
/// characteristic function is not good enough, the error says so, or there is no quantile.
TEST(LinearDistribution, ErrorsHoldTheTrueQuantile) {
    std::mt19937_64 bits(5);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    };
    const auto of_size = [&](double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    };
    int known = 0;
    constexpr int cases = 60;
    for (int n = 0; n < cases; ++n) {
        const std::array<Distribution, 8> shapes{
            Distribution::of(Rectangular{-1.0, 1.0}),
            Distribution::of(Arcsine{-1.0, 1.0}),
            Distribution::of(Beta{0.0, 1.0, 0.1, 0.2}),
            Distribution::of(Beta{0.0, 1.0, of_size(0.3, 10.0), of_size(0.3, 10.0)}),
            Distribution::of(Gamma{of_size(0.01, 10.0), 1.0}),
            Distribution::of(Lognormal{0.0, of_size(0.05, 2.5)}),
            Distribution::of(StudentT{0.0, 1.0, of_size(2.1, 50.0)}),
            Distribution::of(Lognormal{0.0, 2.0})};
        const Distribution& shape = shapes[bits() % shapes.size()];
        const double sigma = shape.standard_deviation() * of_size(1e-4, 1.0);
        const double tail = of_size(5e-5, 0.1), p = bits() % 2 == 0 ? tail : 1.0 - tail;
        const LinearDistribution sum({term(shape), term(Distribution::normal(sigma))});
        const auto found = sum.known_quantile(p);
        if (!found || !std::isfinite(found->error)) continue;
        SCOPED_TRACE(std::string(shape.title()) + " case " + std::to_string(n));
        ++known;
        constexpr double of_integral = 1e-9;
        EXPECT_LE(exact_with_noise(shape, sigma, found->value - found->error), p + of_integral);
        EXPECT_GE(exact_with_noise(shape, sigma, found->value + found->error), p - of_integral);
    }
    EXPECT_GT(known, cases / 3);  // or nothing was tested
}

TEST(LinearDistribution, JumpsHaveNoQuantile) {
    const Distribution coin = Distribution::of(Discrete{{0.0, 1.0}, {0.5, 0.5}});
    EXPECT_EQ(LinearDistribution({term(coin)}).quantile(0.975), std::nullopt);
    EXPECT_EQ(LinearDistribution({term(coin), term(coin, 0.3)}).quantile(0.975), std::nullopt);
}

}  // namespace
}  // namespace covaria::linear_distribution_test
