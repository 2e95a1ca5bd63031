// Characteristic functions against integrals over the quantile functions, and against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "core/math/normal_quantile.h"
#include "core/quantity/characteristic_function.h"
#include "distribution_cases.h"

namespace covaria::characteristic_function_test {
namespace {

using Complex = std::complex<double>;

/// E exp(i t (X - m)) by the trapezoidal rule over scores.
Complex integral(const Distribution& distribution, double t) {
    constexpr double step = 0.001, end = 8.5;
    std::vector<double> z, x;
    for (double score = -end; score <= end; score += step) z.push_back(score);
    x.resize(z.size());
    distribution.from_standard_normal(z, x);
    Complex sum = 0.0;
    for (std::size_t k = 0; k < z.size(); ++k)
        sum += step * normal_density(z[k]) * std::polar(1.0, t * (x[k] - distribution.mean()));
    return sum;
}

TEST(CharacteristicFunction, IsTheIntegralOverTheQuantileFunction) {
    for (const Distribution& distribution : distribution_cases()) {
        if (distribution.standard_deviation() == 0.0 || distribution.kind() == "discrete") continue;
        const CharacteristicFunction function(distribution);
        const double u = distribution.standard_deviation();
        for (const double tau : {0.01, 0.3, 1.0, 2.5, 6.0}) {
            const double t = tau / (std::isfinite(u) ? u : distribution.standard_uncertainty());
            // The far tail of one degree of freedom turns faster than the steps of the integral.
            const double tolerance = distribution.degrees_of_freedom() <= 2.6 ? 1e-4 : 1e-8;
            EXPECT_LT(std::abs(function(t) - integral(distribution, t)), tolerance)
                << distribution.title() << " at " << tau;
        }
    }
}

TEST(CharacteristicFunction, OfStudentTHasClosedFormsForOddDegreesOfFreedom) {
    const CharacteristicFunction one(Distribution::of(StudentT{7.0, 2.0, 1.0}));
    const CharacteristicFunction three(Distribution::of(StudentT{0.0, 1.0, 3.0}));
    for (const double t : {1e-4, 0.01, 0.2, 1.0, 3.0, 9.0}) {
        EXPECT_NEAR(one(t).real(), std::exp(-2.0 * t), 1e-9) << t;
        const double s = std::numbers::sqrt3 * t;
        EXPECT_NEAR(three(t).real(), (1.0 + s) * std::exp(-s), 1e-9) << t;
        EXPECT_NEAR(three(-t).real(), three(t).real(), 1e-15);
    }
}

TEST(CharacteristicFunction, OfDiscreteValuesIsASum) {
    const CharacteristicFunction function(Distribution::of(Discrete{{1.0, 2.0, 5.0}, {0.5, 0.25, 0.25}}));
    const double mean = 2.25, t = 1.7;
    const Complex exact = 0.5 * std::polar(1.0, t * (1.0 - mean)) + 0.25 * std::polar(1.0, t * (2.0 - mean)) +
                          0.25 * std::polar(1.0, t * (5.0 - mean));
    EXPECT_LT(std::abs(function(t) - exact), 1e-15);
}

/// Sums over their values, and a mean over the probability.
TEST(CharacteristicFunction, OfStepsIsTheirMean) {
    for (const Distribution& distribution : stepped_cases()) {
        const CharacteristicFunction function(distribution);
        for (const double tau : {0.01, 0.7, 2.5, 40.0}) {
            const double t = tau / distribution.standard_deviation();
            Complex mean = 0.0;
            if (distribution.has_jumps()) {
                const Discrete table = values_with_probabilities(distribution);
                for (std::size_t i = 0; i < table.values.size(); ++i)
                    mean +=
                        table.probabilities[i] * std::polar(1.0, t * (table.values[i] - distribution.mean()));
                EXPECT_LT(std::abs(function(t) - mean), 1e-11) << described(distribution) << " at " << tau;
                continue;
            }
            constexpr int count = 1'000'000;
            for (int i = 0; i < count; ++i)
                mean += std::polar(1.0 / count,
                                   t * (distribution.quantile((i + 0.5) / count) - distribution.mean()));
            EXPECT_LT(std::abs(function(t) - mean), 1e-6) << described(distribution) << " at " << tau;
        }
    }
}

/// |t| far beyond what the integral above can follow: sin(3t)/(3t) and so on, with mean and shift.
TEST(CharacteristicFunction, HoldsFarOut) {
    const double t = 431.7;
    EXPECT_NEAR(CharacteristicFunction(Distribution::of(Rectangular{1.0, 7.0}))(t).real(),
                std::sin(3.0 * t) / (3.0 * t), 1e-15);
    // Curvilinear trapezoid with a negligible inexactness, and as a product of two rectangular variables.
    const CharacteristicFunction nearly(Distribution::of(CurvilinearTrapezoid{1.0, 7.0, 1e-3}));
    EXPECT_NEAR(nearly(t).real(), std::sin(3.0 * t) / (3.0 * t) * std::sin(1e-3 * t) / (1e-3 * t), 3e-7);
    // Exponential with the opposite sign.
    const Complex turned = CharacteristicFunction(Distribution::of(Exponential{2.0}).scaled(-1.0))(0.7);
    EXPECT_LT(std::abs(turned - std::polar(1.0, 1.4) / Complex(1.0, 1.4)), 1e-14);
}

}  // namespace
}  // namespace covaria::characteristic_function_test
