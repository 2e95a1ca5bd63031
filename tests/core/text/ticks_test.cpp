// Ticks: steps of 1, 2, 5, equal decimals, powers of ten in the title.
#include "core/text/ticks.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/text/round_numbers.h"

namespace covaria::ticks_test {
namespace {

TEST(RoundedDown, NeverUpAndNeverAMultipleDown) {
    EXPECT_DOUBLE_EQ(rounded_down(1.0199, 3), 1.01);
    EXPECT_DOUBLE_EQ(rounded_down(1.02, 3), 1.02);
    EXPECT_DOUBLE_EQ(rounded_down(0.0029999, 3), 0.00299);
    EXPECT_DOUBLE_EQ(rounded_down(1234.0, 2), 1200.0);
    EXPECT_DOUBLE_EQ(rounded_down(0.0, 3), 0.0);
}

using Texts = std::vector<std::string>;

Texts texts(const Ticks& ticks) {
    Texts list;
    for (const Tick& tick : ticks.ticks) list.push_back(tick.text);
    return list;
}

TEST(LinearTicks, AreStepsOfOneTwoFive) {
    EXPECT_EQ(texts(linear_ticks(0.0, 1.0, 5)), Texts({"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(texts(linear_ticks(0.0, 1.0, 4)), Texts({"0.0", "0.5", "1.0"}));
    EXPECT_EQ(texts(linear_ticks(0.0, 1.0, 4, {",", "."})), Texts({"0,0", "0,5", "1,0"}));
    EXPECT_EQ(texts(linear_ticks(-0.013, 0.011, 3)), Texts({"−0.01", "0.00", "0.01"}));
    EXPECT_EQ(texts(linear_ticks(1174.88, 1174.96, 4)),
              Texts({"1174.88", "1174.90", "1174.92", "1174.94", "1174.96"}));
    EXPECT_TRUE(linear_ticks(1.0, 1.0, 5).ticks.empty());
}

TEST(LinearTicks, StayInsideTheRangeAndAreNotTooMany) {
    for (const double high : {1.0, 1.7, 3.2, 9.99, 123.0, 7.7e4})
        for (int most = 1; most <= 9; ++most) {
            const Ticks ticks = linear_ticks(-0.3 * high, high, most);
            EXPECT_LE(static_cast<int>(ticks.ticks.size()), most + 1);
            for (const Tick& tick : ticks.ticks) {
                EXPECT_GE(tick.at, -0.3 * high - 1e-9 * high);
                EXPECT_LE(tick.at, high + 1e-9 * high);
            }
        }
}

TEST(LinearTicks, TakeLargeAndSmallPowersOutOfTheTexts) {
    const Ticks large = linear_ticks(0.0, 3e6, 3);
    EXPECT_EQ(large.exponent, 6);
    EXPECT_EQ(texts(large), Texts({"0", "1", "2", "3"}));
    const Ticks small = linear_ticks(0.0, 4e-6, 2);
    EXPECT_EQ(small.exponent, -6);
    EXPECT_EQ(texts(small), Texts({"0", "2", "4"}));
    EXPECT_EQ(linear_ticks(0.0, 50'000.0, 5).exponent, 0);
    EXPECT_EQ(linear_ticks(0.0, 0.05, 5).exponent, 0);
    const Ticks written_out = linear_ticks(50'000'600.0, 50'001'000.0, 3, {}, 0);
    EXPECT_EQ(written_out.exponent, 0);
    EXPECT_EQ(written_out.ticks.front().text, "50\u202f000\u202f600");
    const Ticks asked_for = linear_ticks(1.6e-5, 2.0e-5, 2, {}, -6);
    EXPECT_EQ(asked_for.exponent, -6);
    EXPECT_EQ(texts(asked_for), Texts({"16", "18", "20"}));
    EXPECT_EQ(axis_exponent(1.8e-5), -6);
    EXPECT_EQ(axis_exponent(3e6), 6);
}

TEST(LogarithmicTicks, AreDecadesOrOneTwoFive) {
    EXPECT_EQ(texts(logarithmic_ticks(3.9, 6.1, 6)), Texts({"10⁴", "10⁵", "10⁶"}));
    EXPECT_EQ(texts(logarithmic_ticks(0.0, 9.0, 5)), Texts({"10⁰", "10²", "10⁴", "10⁶", "10⁸"}));
    EXPECT_EQ(texts(logarithmic_ticks(4.2, 4.9, 5)), Texts({"20\u202f000", "50\u202f000"}));
    EXPECT_GE(logarithmic_ticks(4.35, 4.6, 4).ticks.size(), 2U) << "inside a single step: linear";
}

TEST(RoundNumbers, NearestBelowAboveAndTexts) {
    EXPECT_DOUBLE_EQ(nearest_round_number(109), 100);
    EXPECT_DOUBLE_EQ(nearest_round_number(1600), 2000);
    EXPECT_DOUBLE_EQ(nearest_round_number(0.08), 0.1);
    EXPECT_DOUBLE_EQ(round_number_below(499), 200);
    EXPECT_DOUBLE_EQ(round_number_below(500), 500);
    EXPECT_DOUBLE_EQ(round_number_above(201), 500);
    EXPECT_DOUBLE_EQ(round_number_above(200), 200);
    EXPECT_EQ(round_number_text(2000), "2000");
    EXPECT_EQ(round_number_text(0.05), "0.05");
}

}  // namespace
}  // namespace covaria::ticks_test
