// Ticks of any range of doubles: few, inside, each with a text of its own, and always at an end.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "core/text/round_numbers.h"
#include "core/text/ticks.h"
#include "tests/random_figures.h"

namespace covaria::any_range_test {
namespace {

void expect_an_axis(const Ticks& ticks, double low, double high, int most, const std::string& what) {
    EXPECT_LE(ticks.ticks.size(), static_cast<std::size_t>(most) + 1) << what;
    std::set<std::string> texts;
    double before = -std::numeric_limits<double>::infinity();
    const double slack = 2e-9 * (0.5 * high - 0.5 * low);
    for (const Tick& tick : ticks.ticks) {
        EXPECT_GT(tick.at, before) << what;
        EXPECT_GE(tick.at, low - slack) << what;
        EXPECT_LE(tick.at, high + slack) << what;
        EXPECT_TRUE(texts.insert(tick.text).second) << what << ": " << tick.text << " twice";
        EXPECT_EQ(tick.text.find('\0'), std::string::npos) << what;
        EXPECT_LT(tick.text.size(), 1500u) << what;
        before = tick.at;
    }
}

std::string words(double low, double high, int most) {
    return std::to_string(most) + " in " + std::to_string(low) + ", width " +
           std::to_string((high - low) / (std::nextafter(high, 1e308) - high)) + " steps of a double";
}

TEST(Ticks, OfAnyRangeAreFewAndInside) {
    test::RandomFigures figures(42);
    std::size_t with_ticks = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto [low, high] = figures.range();
        const int most = 1 + static_cast<int>(figures.below(12));
        const Ticks ticks = linear_ticks(low, high, most);
        with_ticks += ticks.ticks.empty() ? 0 : 1;
        expect_an_axis(ticks, low, high, most, words(low, high, most));
        if (HasFailure()) return;
    }
    EXPECT_GT(with_ticks, 12'000u) << "nearly every range has a round number in it";
}

TEST(Ticks, OfAnyLogarithmicRangeAreFewAndInside) {
    test::RandomFigures figures(43);
    for (int i = 0; i < 20'000; ++i) {
        const auto [one, other] = figures.range();
        const double low = std::log10(std::abs(one)), high = std::log10(std::abs(other));
        const int most = 1 + static_cast<int>(figures.below(12));
        const Ticks ticks = logarithmic_ticks(std::min(low, high), std::max(low, high), most);
        EXPECT_LE(ticks.ticks.size(), static_cast<std::size_t>(most) + 1) << words(low, high, most);
        for (const Tick& tick : ticks.ticks) EXPECT_TRUE(std::isfinite(tick.at)) << words(low, high, most);
        if (HasFailure()) return;
    }
}

// Frequency of caesium with today's uncertainty: steps are no smaller than what two doubles differ by.
TEST(Ticks, OfAnAxisBelowTheResolutionOfItsNumbers) {
    const double caesium = 9'192'631'770.0;
    for (const double half : {1e-300, 1e-12, 1e-6, 4e-6, 1e-5, 1e-3}) {
        const Ticks ticks = linear_ticks(caesium - half, caesium + half, 6);
        expect_an_axis(ticks, caesium - half, caesium + half, 6, std::to_string(half));
        if (half > 1e-5) {
            EXPECT_GE(ticks.ticks.size(), 2u) << half;
        }
    }
}

TEST(Multiples, AreNoneWhereThereWouldBeTooMany) {
    EXPECT_EQ(multiples_between(0.0, 10.0, 1.0, 11).size(), 11u);
    EXPECT_TRUE(multiples_between(0.0, 10.0, 1.0, 10).empty());
    EXPECT_TRUE(multiples_between(1e57, 1e57, 1e-3, 64).size() <= 1);
    EXPECT_TRUE(multiples_between(0.0, 1.0, 0.0, 64).empty());
    EXPECT_TRUE(multiples_between(0.0, 1.0, std::numeric_limits<double>::quiet_NaN(), 64).empty());
    EXPECT_TRUE(multiples_between(-1e308, 1e308, 1e-300, 64).empty());
}

}  // namespace
}  // namespace covaria::any_range_test
