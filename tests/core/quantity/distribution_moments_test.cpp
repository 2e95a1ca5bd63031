// Moments of distributions against the reference values, by integration over the quantile function.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/math/normal_quantile.h"
#include "distribution_cases.h"

namespace covaria::distribution_moments_test {
namespace {

using nlohmann::json;

Distribution from_reference(const json& s) {
    const auto n = [&](const char* key) { return s.at(key).get<double>(); };
    const std::string type = s.at("type");
    if (type == "rect") return Distribution::of(Rectangular{n("a"), n("b")});
    if (type == "ctrap") return Distribution::of(CurvilinearTrapezoid{n("a"), n("b"), n("d")});
    if (type == "trap") return Distribution::of(Trapezoidal{n("a"), n("b"), n("beta")});
    if (type == "tri") return Distribution::of(Triangular{n("a"), n("b")});
    if (type == "arcsine") return Distribution::of(Arcsine{n("a"), n("b")});
    if (type == "normal") return Distribution::of(Normal{n("mean"), n("std")});
    if (type == "t") return Distribution::of(StudentT{n("mean"), n("scale"), n("nu")});
    if (type == "expon") return Distribution::of(Exponential{n("mean")});
    if (type == "gamma") return Distribution::of(Gamma{n("shape"), n("scale")});
    if (type == "truncnormal") return Distribution::of(TruncatedNormal{n("mu"), n("sigma"), n("a"), n("b")});
    if (type == "lognormal") return Distribution::of(Lognormal{n("mu"), n("sigma")});
    if (type == "beta") return Distribution::of(Beta{n("a"), n("b"), n("p"), n("q")});
    if (type == "poisson") return Distribution::of(Poisson{n("lam"), 1.0, 0.0});
    if (type == "discrete") return Distribution::of(Discrete{s.at("values"), s.at("probs")});
    ADD_FAILURE() << "unknown type " << type;
    return {};
}

struct Moments {
    double mean, standard_deviation, skewness, excess_kurtosis;
};

/// Weighted values of the variable that represent its distribution: the trapezoidal rule over the normal
/// score, or, for steps, the midpoint rule over the probability.
Moments integrated(const Distribution& distribution) {
    std::vector<double> p, weight;
    if (distribution.has_jumps()) {
        constexpr int count = 2000000;
        for (int i = 0; i < count; ++i) p.push_back((i + 0.5) / count), weight.push_back(1.0 / count);
    } else {
        constexpr double step = 1.0 / 1024;
        for (double z = -8.2; z < 8.2; z += step)
            p.push_back(normal_distribution_function(z)), weight.push_back(step * normal_density(z));
    }
    std::vector<double> x(p.size());
    distribution.quantiles(p, x);
    const auto expectation = [&](auto f) {
        double sum = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += weight[i] * f(x[i]);
        return sum;
    };
    const double mean = expectation([](double v) { return v; });
    const auto central = [&](int power) {
        return expectation([&](double v) { return std::pow(v - mean, power); });
    };
    const double variance = central(2);
    return {mean, std::sqrt(variance), central(3) / std::pow(variance, 1.5),
            central(4) / (variance * variance) - 3.0};
}

TEST(DistributionMoments, ReproduceTheReferenceValues) {
    std::ifstream file(COVARIA_SOURCE_DIR "/tests/data/gum_examples.json");
    const json cases = json::parse(file).at("distributions");
    ASSERT_EQ(cases.size(), 14u);
    for (const json& c : cases) {
        SCOPED_TRACE(c.at("name").get<std::string>());
        const Distribution distribution = from_reference(c.at("spec"));
        const double mean = c.at("mean"), deviation = c.at("std");
        EXPECT_NEAR(distribution.mean(), mean, 1e-9 * deviation);
        EXPECT_NEAR(distribution.standard_deviation(), deviation, 1e-9 * deviation);
        const Moments m = integrated(distribution);
        EXPECT_NEAR(m.mean, mean, 2e-6 * deviation);
        EXPECT_NEAR(m.standard_deviation, deviation, 2e-6 * deviation);
        EXPECT_NEAR(m.skewness, c.at("skew").get<double>(), 2e-5);
        EXPECT_NEAR(m.excess_kurtosis, c.at("excess_kurtosis").get<double>(), 2e-4);
    }
}

TEST(DistributionMoments, OfAwkwardCasesAgreeWithTheirQuantiles) {
    for (const Distribution& distribution : distribution_cases()) {
        SCOPED_TRACE(described(distribution));
        if (!std::isfinite(distribution.standard_deviation())) continue;
        const auto* t = std::get_if<StudentT>(&distribution.parameters());
        if (t != nullptr && t->degrees_of_freedom < 4.0) continue;  // too much lies beyond the last node
        const Moments m = integrated(distribution);
        const double scale = m.standard_deviation;
        EXPECT_NEAR(distribution.mean(), m.mean, 2e-6 * scale);
        EXPECT_NEAR(distribution.standard_deviation(), m.standard_deviation, 2e-6 * scale);
    }
}

/// The quantiles are the values themselves; a histogram takes the midpoint rule over the probability.
TEST(DistributionMoments, OfStepsAgreeWithTheirQuantiles) {
    for (const Distribution& distribution : stepped_cases()) {
        SCOPED_TRACE(described(distribution));
        constexpr int count = 1'000'000;
        std::vector<double> p(count), x(count);
        for (int i = 0; i < count; ++i) p[static_cast<std::size_t>(i)] = (i + 0.5) / count;
        distribution.quantiles(p, x);
        double sum = 0.0, square = 0.0;
        for (const double value : x) sum += value;
        for (const double value : x) square += (value - sum / count) * (value - sum / count);
        const double deviation = distribution.standard_deviation();
        EXPECT_NEAR(distribution.mean(), sum / count, 2e-5 * deviation);
        EXPECT_NEAR(deviation, std::sqrt(square / count), 5e-5 * deviation);
        if (!distribution.has_jumps()) continue;
        const Discrete table = values_with_probabilities(distribution);
        double mean = 0.0, whole = 0.0;
        for (std::size_t i = 0; i < table.values.size(); ++i) {
            mean += table.probabilities[i] * table.values[i];
            whole += table.probabilities[i];
        }
        EXPECT_NEAR(whole, 1.0, 1e-12);
        EXPECT_NEAR(mean, distribution.mean(), 1e-12 * (1.0 + std::abs(mean)));
    }
}

TEST(DistributionMoments, OfAHistogramItsDensityIsThatOfItsCells) {
    const Distribution h = Distribution::of(StatedHistogram{{0.0, 1.0, 3.0, 4.0}, {0.5, 0.0, 0.5}});
    EXPECT_EQ(h.density(0.5), 0.5);
    EXPECT_EQ(h.density(2.0), 0.0);
    EXPECT_EQ(h.density(3.5), 0.5);
    EXPECT_EQ(h.density(-0.1), 0.0);
    EXPECT_EQ(h.density(4.1), 0.0);
    EXPECT_DOUBLE_EQ(h.mean(), 2.0);
    EXPECT_DOUBLE_EQ(h.standard_deviation(), std::sqrt(1.5 * 1.5 + 1.0 / 12.0));
    EXPECT_EQ(Distribution::of(Poisson{3.0, 1.0, 0.0}).density(3.0), 0.0);
    EXPECT_EQ(Distribution::of(Weibull{1.0, 2.0, 1.5}).density(0.9), 0.0);
    EXPECT_EQ(Distribution::of(Weibull{1.0, -2.0, 1.5}).density(1.1), 0.0);
}

TEST(DistributionMoments, StudentTHasAScaleAndAStandardDeviation) {  // JCGM 101 6.4.9.5, JCGM 100 G.3
    const Distribution t = Distribution::of(StudentT{1.0, 2.0, 6.0});
    EXPECT_DOUBLE_EQ(t.standard_deviation(), 2.0 * std::sqrt(1.5));
    EXPECT_EQ(t.standard_uncertainty(), 2.0);
    EXPECT_EQ(t.degrees_of_freedom(), 6.0);
    EXPECT_EQ(Distribution::of(StudentT{0.0, 1.0, 2.0}).standard_deviation(), infinity);
    EXPECT_EQ(Distribution::of(StudentT{0.0, 1.0, infinity}).standard_deviation(), 1.0);
    EXPECT_EQ(Distribution::normal(0.5).degrees_of_freedom(), infinity);
    EXPECT_EQ(Distribution::normal(0.5).standard_uncertainty(), 0.5);
}

TEST(DistributionMoments, OfATruncatedNormalKeepTheirDigits) {
    // Narrow: practically rectangular. Far out: practically exponential with mean 1/30 beyond the limit.
    const Distribution narrow = Distribution::of(TruncatedNormal{0.0, 1.0, -1e-5, 1e-5});
    EXPECT_NEAR(narrow.standard_deviation() / (2e-5 / std::sqrt(12.0)), 1.0, 1e-9);
    const Distribution far = Distribution::of(TruncatedNormal{0.0, 1.0, 30.0, infinity});
    EXPECT_NEAR(far.mean(), 30.0 + 1.0 / 30 - 2.0 / 27000, 1e-6);
    EXPECT_NEAR(far.quantile(0.5), 30.0 + std::log(2.0) / 30, 5e-5);
}

TEST(DistributionMoments, DensityIsTheDerivativeOfTheDistributionFunction) {
    for (const Distribution& distribution : distribution_cases()) {
        SCOPED_TRACE(described(distribution));
        for (const double p : {0.003, 0.02, 0.11, 0.26, 0.41, 0.63, 0.87, 0.98, 0.997}) {
            const double h = 1e-6;
            const double slope = (distribution.quantile(p + h) - distribution.quantile(p - h)) / (2.0 * h);
            EXPECT_NEAR(slope * distribution.density(distribution.quantile(p)), 1.0, 2e-5) << p;
        }
    }
}

TEST(DistributionMoments, DensityVanishesOutside) {
    EXPECT_EQ(Distribution::of(Rectangular{0.0, 1.0}).density(1.1), 0.0);
    EXPECT_EQ(Distribution::of(Triangular{0.0, 1.0}).density(-0.1), 0.0);
    EXPECT_EQ(Distribution::of(CurvilinearTrapezoid{0.0, 1.0, 0.1}).density(1.11), 0.0);
    EXPECT_GT(Distribution::of(CurvilinearTrapezoid{0.0, 1.0, 0.1}).density(1.09), 0.0);
    EXPECT_EQ(Distribution::of(Exponential{1.0}).density(-0.1), 0.0);
    EXPECT_EQ(Distribution::of(Gamma{2.0, 1.0}).density(-0.1), 0.0);
    EXPECT_EQ(Distribution::of(Beta{0.0, 1.0, 2.0, 2.0}).density(1.0), 0.0);
    EXPECT_EQ(Distribution::of(Beta{0.0, 2.0, 1.0, 3.0}).density(0.0), 1.5);
    EXPECT_EQ(Distribution::normal(0.0).density(0.1), 0.0);
    EXPECT_EQ(discrete_case().density(1.0), 0.0);
}

}  // namespace
}  // namespace covaria::distribution_moments_test
