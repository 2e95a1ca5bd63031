// Parameters that Distribution refuses, and the table of kinds.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/base/guarded.h"
#include "distribution_cases.h"

namespace covaria::distribution_checks_test {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

void expect_refused(const DistributionParameters& parameters, std::string_view part) {
    const Result<Distribution> made = Distribution::make(parameters);
    ASSERT_FALSE(made.has_value()) << part;
    EXPECT_NE(made.error().message.english().find(part), std::string::npos) << made.error().message.english();
    EXPECT_EQ(made.error().code, ErrorCode::bad_input);
}

TEST(DistributionChecks, NameTheBadParameter) {
    expect_refused(Normal{0.0, -1.0}, "normal distribution: the standard deviation must not be negative");
    expect_refused(Normal{nan_value, 1.0}, "mean value");
    expect_refused(Normal{0.0, infinity}, "standard deviation");
    expect_refused(StudentT{0.0, 1.0, 0.0}, "degrees of freedom");
    expect_refused(StudentT{0.0, 1.0, nan_value}, "degrees of freedom");
    expect_refused(StudentT{0.0, -1.0, 3.0}, "scale");
    expect_refused(Rectangular{1.0, 0.0}, "lower limit must not be greater");
    expect_refused(Rectangular{-infinity, 0.0}, "lower limit");
    expect_refused(Rectangular{-1.7e308, 1.7e308}, "too large");
    expect_refused(CurvilinearTrapezoid{0.0, 1.0, 0.6}, "inexactness");
    expect_refused(CurvilinearTrapezoid{0.0, 1.0, -0.1}, "inexactness");
    expect_refused(Trapezoidal{0.0, 1.0, 1.1}, "beta");
    expect_refused(Trapezoidal{0.0, 1.0, nan_value}, "beta");
    expect_refused(Triangular{0.0, nan_value}, "upper limit");
    expect_refused(Arcsine{2.0, 1.0}, "lower limit");
    expect_refused(Exponential{-1.0}, "mean value");
    expect_refused(Gamma{0.0, 1.0}, "shape");
    expect_refused(Gamma{1e9, 1.0}, "shape");
    expect_refused(Gamma{nan_value, 1.0}, "shape");
    expect_refused(StudentT{0.0, 1.0, 0.19}, "degrees of freedom");
    expect_refused(Gamma{1.0, -1.0}, "scale");
    expect_refused(TruncatedNormal{0.0, 1.0, 2.0, 1.0}, "lower limit");
    expect_refused(TruncatedNormal{0.0, 1.0, nan_value, 1.0}, "lower limit");
    expect_refused(TruncatedNormal{0.0, 1.0, infinity, infinity}, "excludes every value");
    expect_refused(TruncatedNormal{0.0, 1.0, 50.0, 60.0}, "no probability is left");
    expect_refused(TruncatedNormal{0.0, 0.0, 1.0, 2.0}, "outside the limits");
    expect_refused(Lognormal{0.0, 30.0}, "no finite variance");
    expect_refused(Lognormal{0.0, -0.1}, "standard deviation of the logarithm");
    expect_refused(Beta{0.0, 1.0, 0.0, 1.0}, "alpha");
    expect_refused(Beta{0.0, 1.0, 1.0, infinity}, "beta");
    expect_refused(Discrete{}, "at least one value");
    expect_refused(Discrete{{1.0, 2.0}, {1.0}}, "as many probabilities");
    expect_refused(Discrete{{1.0, 2.0}, {0.5, 0.4}}, "sum to 1");
    expect_refused(Discrete{{1.0, 2.0}, {1.5, -0.5}}, "must not be negative");
    expect_refused(Discrete{{1.0, nan_value}, {0.5, 0.5}}, "values");
    expect_refused(Laplace{0.0, -1.0}, "Laplace distribution: the scale must not be negative");
    expect_refused(Weibull{0.0, 1.0, 0.05}, "shape");
    expect_refused(Weibull{0.0, nan_value, 2.0}, "scale");
    expect_refused(Poisson{-1.0, 1.0, 0.0}, "expected number of events");
    expect_refused(Poisson{2e7, 1.0, 0.0}, "normal distribution says the same");
    expect_refused(Poisson{nan_value, 1.0, 0.0}, "expected number of events");
    expect_refused(Binomial{2.5, 0.5, 1.0, 0.0}, "whole number");
    expect_refused(Binomial{2.0, 1.1, 1.0, 0.0}, "probability must lie between 0 and 1");
    expect_refused(StatedHistogram{{0.0}, {}}, "at least one cell");
    expect_refused(StatedHistogram{{0.0, 1.0}, {0.5, 0.5}}, "one edge more");
    expect_refused(StatedHistogram{{0.0, 1.0, 1.0}, {0.5, 0.5}}, "edges must rise");
    expect_refused(StatedHistogram{{0.0, 1.0, nan_value}, {0.5, 0.5}}, "edges");
    expect_refused(StatedHistogram{{0.0, 1.0, 2.0}, {0.5, 0.6}}, "sum to 1");
}

TEST(DistributionChecks, TheLimitsOfTheShapesCanBeComputed) {
    std::vector<DistributionParameters> extremes{StudentT{0.0, 1.0, 0.2}, StudentT{0.0, 1.0, 1e300},
                                                 Gamma{1e-3, 1.0}, Gamma{1e6, 1.0}};
    for (const double a : {1e-3, 1.0, 1e6})
        for (const double b : {1e-3, 1.0, 1e6}) extremes.push_back(Beta{0.0, 1.0, a, b});
    for (const DistributionParameters& parameters : extremes) {
        const Distribution distribution = Distribution::of(parameters);
        double last = -infinity;
        for (const double p : {0x1p-53, 1e-9, 0.01, 0.3, 0.5, 0.8, 0.999, 1.0 - 1e-9, 1.0 - 0x1p-53}) {
            const double x = distribution.quantile(p);
            EXPECT_TRUE(std::isfinite(x)) << described(distribution) << " at " << p;
            EXPECT_GE(x, last - 1e-10 * std::abs(last)) << described(distribution) << " at " << p;
            last = x;
        }
    }
}

TEST(DistributionChecks, OfThrowsOnABadParameter) {
    EXPECT_THROW(Distribution::normal(-1.0), ImpossibleValue);
    EXPECT_THROW(Distribution::normal(1e160), ImpossibleValue);
    EXPECT_NE(guarded([] { return Distribution::normal(-1.0); })
                  .error()
                  .message.english()
                  .find("standard deviation"),
              std::string::npos);
}

TEST(DistributionKinds, FollowTheOrderOfTheParameters) {
    const auto& kinds = distribution_kinds();
    ASSERT_EQ(kinds.size(), std::variant_size_v<DistributionParameters>);
    std::vector<Distribution> cases = distribution_cases();
    for (const Distribution& stepped : stepped_cases()) cases.push_back(stepped);
    std::set<std::string_view> seen;
    for (const Distribution& distribution : cases) {
        const DistributionKindInfo& info = kinds[distribution.parameters().index()];
        EXPECT_EQ(distribution.kind(), info.key);
        EXPECT_EQ(distribution.title(), info.title);
        if (!info.parameters.empty()) {
            EXPECT_EQ(distribution_parameters(distribution).size(), info.parameters.size());
        }
        seen.insert(info.key);
    }
    EXPECT_EQ(seen.size(), kinds.size());
}

TEST(DistributionKinds, RoundTripThroughTheirParameters) {
    std::vector<Distribution> cases = distribution_cases();
    for (const Distribution& stepped : stepped_cases()) cases.push_back(stepped);
    for (const Distribution& distribution : cases) {
        const auto again = distribution_from(distribution.kind(), distribution_parameters(distribution));
        ASSERT_TRUE(again.has_value()) << described(distribution);
        EXPECT_EQ(again->parameters(), distribution.parameters()) << described(distribution);
    }
    const auto trapezoid = distribution_from("trapezoidal", std::vector{1.0, 2.0, 0.3});
    EXPECT_EQ(trapezoid->parameters(), DistributionParameters(Trapezoidal{1.0, 2.0, 0.3}));
}

TEST(DistributionKinds, RefuseWhatDoesNotFit) {
    EXPECT_NE(distribution_from("gaussian", std::vector{0.0, 1.0})
                  .error()
                  .message.english()
                  .find("Known distributions: normal"),
              std::string::npos);
    EXPECT_NE(distribution_from("normal", std::vector{0.0})
                  .error()
                  .message.english()
                  .find("2 parameters are needed, 1"),
              std::string::npos);
    EXPECT_FALSE(distribution_from("discrete", std::vector{0.0, 1.0, 1.0}).has_value());
    EXPECT_FALSE(distribution_from("discrete", {}).has_value());
    EXPECT_FALSE(distribution_from("histogram", {}).has_value());
    EXPECT_FALSE(distribution_from("histogram", std::vector{0.0, 1.0, 0.5, 0.5}).has_value());
    EXPECT_FALSE(distribution_from("poisson", std::vector{1.0}).has_value());
    EXPECT_FALSE(distribution_from("normal", std::vector{0.0, -1.0}).has_value());
}

}  // namespace
}  // namespace covaria::distribution_checks_test
