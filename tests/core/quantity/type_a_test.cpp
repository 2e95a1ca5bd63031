// Type A evaluation against the worked example H.2 of JCGM 100.
#include "core/quantity/type_a.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace covaria::type_a_test {
namespace {

// JCGM 100 table H.2: simultaneous observations of voltage/V, current/mA and phase/rad, and its means and
// uncertainties.
constexpr std::array voltage{5.007, 4.994, 5.005, 4.990, 4.999};
constexpr std::array current{19.663, 19.639, 19.640, 19.685, 19.678};
constexpr std::array phase{1.0456, 1.0438, 1.0468, 1.0428, 1.0433};

TEST(TypeA, ReproducesTableH2) {
    const TypeA v = *type_a_evaluation(voltage);
    EXPECT_NEAR(v.mean, 4.9990, 5e-5);
    EXPECT_NEAR(v.standard_uncertainty, 0.0032, 5e-5);
    EXPECT_EQ(v.degrees_of_freedom, 4.0);
    EXPECT_DOUBLE_EQ(v.standard_deviation, v.standard_uncertainty * std::sqrt(5.0));
    EXPECT_NEAR(type_a_evaluation(current)->standard_uncertainty, 0.0095, 5e-5);
    EXPECT_NEAR(type_a_evaluation(phase)->mean, 1.04446, 5e-6);
    EXPECT_NEAR(type_a_evaluation(phase)->standard_uncertainty, 0.00075, 5e-6);
}

TEST(TypeA, ReproducesTheCorrelationsOfTableH2) {
    const auto r = [](const auto& x, const auto& y) {
        return *covariance_of_means(x, y) /
               (type_a_evaluation(x)->standard_uncertainty * type_a_evaluation(y)->standard_uncertainty);
    };
    EXPECT_NEAR(r(voltage, current), -0.36, 0.005);
    EXPECT_NEAR(r(voltage, phase), 0.86, 0.005);
    EXPECT_NEAR(r(current, phase), -0.65, 0.005);
    EXPECT_NEAR(r(current, current), 1.0, 1e-14);
}

TEST(TypeA, KeepsItsDigitsOnALargeOffset) {
    const std::vector<double> x{1e9 + 1e-3, 1e9 + 2e-3, 1e9 + 3e-3};
    const TypeA a = *type_a_evaluation(x);
    EXPECT_NEAR(a.standard_deviation, 1e-3, 2e-7);  // the data themselves are rounded to 1.2e-7
    EXPECT_EQ(type_a_evaluation(std::vector{0.1, 0.1, 0.1})->standard_deviation, 0.0);
}

TEST(TypeA, RefusesTooFewOrBadObservations) {
    EXPECT_FALSE(type_a_evaluation({}).has_value());
    EXPECT_FALSE(type_a_evaluation(std::vector{1.0}).has_value());
    EXPECT_FALSE(type_a_evaluation(std::vector{1.0, std::numeric_limits<double>::infinity()}).has_value());
    EXPECT_FALSE(type_a_evaluation(std::vector{1.0, std::nan("")}).has_value());
    EXPECT_FALSE(covariance_of_means(std::vector{1.0, 2.0}, std::vector{1.0, 2.0, 3.0}).has_value());
    EXPECT_FALSE(covariance_of_means(std::vector{1.0}, std::vector{1.0}).has_value());
    EXPECT_FALSE(covariance_of_means(std::vector{1.0, std::nan("")}, std::vector{1.0, 2.0}).has_value());
}

}  // namespace
}  // namespace covaria::type_a_test
