// Ticks: steps of 1, 2, 5, equal decimals, powers of ten in the title.
#include "ui/charts/ticks.h"

#include <gtest/gtest.h>

#include <QStringList>

namespace covaria::ui::ticks_test {
namespace {

QStringList texts(const Ticks& ticks) {
    QStringList list;
    for (const Tick& tick : ticks.ticks) list << tick.text;
    return list;
}

TEST(LinearTicks, AreStepsOfOneTwoFive) {
    EXPECT_EQ(texts(linear_ticks(0.0, 1.0, 5)), QStringList({"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(texts(linear_ticks(0.0, 1.0, 4)), QStringList({"0.0", "0.5", "1.0"}));
    EXPECT_EQ(texts(linear_ticks(-0.013, 0.011, 3)), QStringList({"−0.01", "0.00", "0.01"}));
    EXPECT_EQ(texts(linear_ticks(1174.88, 1174.96, 4)),
              QStringList({"1174.88", "1174.90", "1174.92", "1174.94", "1174.96"}));
    EXPECT_TRUE(linear_ticks(1.0, 1.0, 5).ticks.empty());
    EXPECT_EQ(texts(linear_ticks(0.0, 1.0, 4, u',')), QStringList({"0,0", "0,5", "1,0"}));
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
    EXPECT_EQ(texts(large), QStringList({"0", "1", "2", "3"}));
    const Ticks small = linear_ticks(0.0, 4e-6, 2);
    EXPECT_EQ(small.exponent, -6);
    EXPECT_EQ(texts(small), QStringList({"0", "2", "4"}));
    EXPECT_EQ(linear_ticks(0.0, 50'000.0, 5).exponent, 0);
    EXPECT_EQ(linear_ticks(0.0, 0.05, 5).exponent, 0);
}

TEST(LogarithmicTicks, AreDecadesOrOneTwoFive) {
    EXPECT_EQ(texts(logarithmic_ticks(3.9, 6.1, 6)), QStringList({"10⁴", "10⁵", "10⁶"}));
    EXPECT_EQ(texts(logarithmic_ticks(0.0, 9.0, 5)), QStringList({"10⁰", "10²", "10⁴", "10⁶", "10⁸"}));
    EXPECT_EQ(texts(logarithmic_ticks(4.2, 4.9, 5)), QStringList({"20\u202f000", "50\u202f000"}));
    EXPECT_GE(logarithmic_ticks(4.35, 4.6, 4).ticks.size(), 2U) << "inside a single step: linear";
}

TEST(TickTitles, TellThePower) {
    EXPECT_EQ(title_with_exponent("x (mm)", 0), "x (mm)");
    EXPECT_EQ(title_with_exponent("x (mm)", -6), "x (10⁻⁶ mm)");
    EXPECT_EQ(title_with_exponent("probability density (1/mm)", 6), "probability density (10⁶/mm)");
    EXPECT_EQ(title_with_exponent("x", 12), "x (10¹²)");
}

TEST(NumberText, HasTrueMinusAndGroups) {
    EXPECT_EQ(number_text(-0.25, 2), "−0.25");
    EXPECT_EQ(number_text(-0.25, 2, u','), "−0,25");
    EXPECT_EQ(number_text(-0.001, 2), "0.00");
    EXPECT_EQ(number_text(1234.5, 1), "1234.5");
    EXPECT_EQ(number_text(1234567.0, 0), "1\u202f234\u202f567");
}

}  // namespace
}  // namespace covaria::ui::ticks_test
