// Rounding rules: U to two digits, the value to match, and the cases where rounding goes wrong.
#include "core/text/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace covaria::numbers_test {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

TEST(FormatSignificant, KeepsTheDigitsAskedFor) {
    EXPECT_EQ(format_significant(0.0664, 2), "0.066");
    EXPECT_EQ(format_significant(1234.5, 2), "1200");
    EXPECT_EQ(format_significant(1234.5, 5), "1234.5");
    EXPECT_EQ(format_significant(0.5, 2), "0.50");
    EXPECT_EQ(format_significant(-0.0664, 2), "-0.066");
}

TEST(FormatSignificant, RoundingUpToTheNextDecadeKeepsTheDigits) {
    EXPECT_EQ(format_significant(0.0996, 2), "0.10");
    EXPECT_EQ(format_significant(9.96, 2), "10");
    EXPECT_EQ(format_significant(99.6, 2), "100");
    EXPECT_EQ(format_significant(0.00099951, 3), "0.00100");
}

TEST(FormatSignificant, ATieGoesAwayFromZeroInEveryUnit) {
    EXPECT_EQ(format_significant(1.55, 2), "1.6");
    EXPECT_EQ(format_significant(0.00155, 2), "0.0016");
    EXPECT_EQ(format_significant(1.55e-6 * 1e3, 2), "0.0016");
    EXPECT_EQ(format_significant(-2.5, 1), "-3");
    EXPECT_EQ(format_significant(0.0015499, 2), "0.0015");
    EXPECT_EQ(format_decimals(1250.0, -2), "1300");
    EXPECT_EQ(format_decimals(50.000000000001, 12), "50.000000000001");
    for (int i = 1005; i < 10000; i += 10)
        for (const double unit : {1.0, 1e-3, 1e-6}) {
            const std::string in_unit = format_significant(i * unit, 3);
            EXPECT_DOUBLE_EQ(std::stod(in_unit), (i / 10 + 1) * 10 * unit);
        }
}

TEST(FormatSignificant, UsesAnExponentOnlyFarFromOne) {
    EXPECT_EQ(format_significant(0.0001, 2), "0.00010");
    EXPECT_EQ(format_significant(0.0000999, 2), "1.0e-04");
    EXPECT_EQ(format_significant(9999999.0, 7), "9999999");
    EXPECT_EQ(format_significant(1.5e7, 2), "1.5e+07");
}

TEST(FormatSignificant, ZeroAndWhatIsNotFinite) {
    EXPECT_EQ(format_significant(0.0, 2), "0");
    EXPECT_EQ(format_significant(inf, 2), "∞");
    EXPECT_EQ(format_significant(-inf, 2), "-∞");
    for (const double nu : {1e4, 6.09e7, inf}) EXPECT_EQ(format_degrees_of_freedom(nu), "∞") << nu;
    EXPECT_EQ(format_degrees_of_freedom(9999.9), "9999");
    EXPECT_EQ(format_degrees_of_freedom(18.97), "19");
    EXPECT_EQ(format_degrees_of_freedom(16.66), "16.7");
    EXPECT_EQ(format_degrees_of_freedom(123.9), "123");
    EXPECT_EQ(format_degrees_of_freedom(9.26), "9.3");
    EXPECT_EQ(format_degrees_of_freedom(3.0), "3");
    EXPECT_EQ(format_degrees_of_freedom(0.25), "0.25");
    EXPECT_EQ(format_significant(std::nan(""), 2), "–");
}

TEST(FormatDecimals, NegativeDecimalsRoundBeforeThePoint) {
    EXPECT_EQ(format_decimals(1234.0, -2), "1200");
    EXPECT_EQ(format_decimals(1251.0, -2), "1300");
    EXPECT_EQ(format_decimals(49.0, -2), "0");
    EXPECT_EQ(format_decimals(-51.0, -2), "-100");
}

TEST(FormatDecimals, NeverShowsAMinusBeforeZero) {
    EXPECT_EQ(format_decimals(-0.0004, 2), "0.00");
    EXPECT_EQ(format_decimals(-49.0, -2), "0");
    EXPECT_EQ(format_decimals(-0.006, 2), "-0.01");
}

TEST(DecimalsFor, FollowsTheRoundedUncertainty) {
    EXPECT_EQ(decimals_for(0.734), 2);
    EXPECT_EQ(decimals_for(0.0996), 2);  // rounds to 0.10
    EXPECT_EQ(decimals_for(0.0994), 3);
    EXPECT_EQ(decimals_for(12.0), 0);
    EXPECT_EQ(decimals_for(1234.0), -2);
    EXPECT_EQ(decimals_for(0.734, 1), 1);
}

TEST(FormatPartOfLimit, WhatExceedsItIsNotOne) {
    EXPECT_EQ(format_part_of_limit(0.5, 2), "0.50");
    EXPECT_EQ(format_part_of_limit(1.0, 2), "1.00");
    EXPECT_EQ(format_part_of_limit(0.9999, 2), "1.00");
    EXPECT_EQ(format_part_of_limit(1.003, 2), "1.003");
    EXPECT_EQ(format_part_of_limit(1.00042, 2), "1.0004");
    EXPECT_EQ(format_part_of_limit(1.01, 2), "1.01");
    EXPECT_EQ(format_part_of_limit(2.0, 2), "2.00");
}

TEST(FormatToMatch, ValueHasTheDecimalsOfItsUncertainty) {
    EXPECT_EQ(format_to_match(1174.9091, 0.3016), "1174.91");
    EXPECT_EQ(format_to_match(-120.0, 0.75), "-120.00");
    EXPECT_EQ(format_to_match(1174.9091, 1234.0), "1200");
    EXPECT_EQ(format_to_match(1174.9091, 0.0996), "1174.91");
}

TEST(FormatToMatch, ZeroOrInfiniteUncertaintyLeavesTheValueAsItIs) {
    EXPECT_EQ(format_to_match(688.0, 0.0), "688");
    EXPECT_EQ(format_to_match(0.066, 0.0), "0.066");
    EXPECT_EQ(format_to_match(688.25, inf), "688.25");
    EXPECT_EQ(format_to_match(0.0, 0.0), "0");
}

TEST(FormatToMatch, TinyUncertaintiesAreShownWithAnExponent) {
    EXPECT_EQ(format_to_match(1.2347e-5, 1.2e-7), "1.235e-05");
    EXPECT_EQ(format_to_match(0.0, 1.2e-7), "0");
    EXPECT_EQ(format_to_match(50.00083821, 8.4e-5), "50.000838");
    EXPECT_EQ(format_to_match(-0.5, 1.2e-7), "-0.50000000");
}

// Typed numbers keep their digits, through units and back; computed ones without an uncertainty have seven.
TEST(FormatTyped, KeepsEveryDigitThatWasTyped) {
    const Unit mm = Unit::of("mm");
    for (const double typed : {344.5, 0.066, 1174.91, 10.000172, 9999.99999, 0.1, 123.456789012, 50000623.0})
        for (const Unit& unit : {mm, Unit::of("deg"), Unit::of("arcsec"), Unit::of("um"), Unit::of("uV")}) {
            const std::string text = format_typed(unit.from_si(unit.to_si(typed)));
            EXPECT_EQ(std::stod(text), typed) << unit.text();
            EXPECT_EQ(text, format_typed(typed)) << unit.text();
        }
    EXPECT_EQ(format_typed(1.0 / 3.0), "0.3333333");
    EXPECT_EQ(format_estimate(10.000172, 0.01), "10.000172");
    EXPECT_EQ(format_estimate(344.0, 0.066), "344.000");
    EXPECT_EQ(format_estimate(10.0 / 3.0, 0.01), "3.333");
    EXPECT_EQ(format_estimate(10.000172, 1e-6), "10.0001720");
}

TEST(FormatInRow, AllNumbersHaveThePowerOfTheLargest) {
    EXPECT_EQ(format_in_row(50.000838, 6, 50.000838), "50.000838");
    EXPECT_EQ(format_in_row(8.4e-5, 6, 50.000838), "0.000084");
    EXPECT_EQ(format_in_row(50000838.2, 0, 50000838.2), "50000838") << "nm: as in the result line";
    EXPECT_EQ(format_in_row(35.4, 0, 50000838.2), "35");
    EXPECT_EQ(format_in_row(1.2345e-5, 8, 1.2345e-5), "1.235e-05");
    EXPECT_EQ(format_in_row(1.2e-7, 8, 1.2345e-5), "0.012e-05");
    EXPECT_EQ(format_in_row(-2.1e11, -8, 2.1e11), "-2.100e+11");
    EXPECT_EQ(format_in_row(1e9, -8, 2.1e11), "0.010e+11");
    EXPECT_EQ(format_in_row(0.0, 3, 1.0), "0.000");
    EXPECT_EQ(format_in_row(0.0, 7, 1.2e-6), "0");
    EXPECT_EQ(format_in_row(1.2e-15, 16, 5.0), "1.2e-15") << "only zeros would be seen";
    EXPECT_EQ(format_in_row(inf, 3, 1.0), "∞");
}

TEST(NumberForm, IsOneForAColumn) {
    EXPECT_EQ(form_of_column(0.01, 120.0), NumberForm::each);
    EXPECT_EQ(form_of_column(3e-5, 0.0012), NumberForm::decimals);
    EXPECT_EQ(form_of_column(3e-9, 0.0012), NumberForm::each) << "only the tiny one has a power";
    EXPECT_EQ(form_of_column(3e-9, 2e-6), NumberForm::powers);
    EXPECT_EQ(form_of_column(0.5, 2e9), NumberForm::powers);
    EXPECT_EQ(format_significant(3.21e-5, 2, NumberForm::decimals), "0.000032");
    EXPECT_EQ(format_significant(0.0012, 2, NumberForm::powers), "1.2e-03");
    EXPECT_EQ(format_significant(0.0, 2, NumberForm::powers), "0");
}

TEST(CommonDecimals, AreThoseOfTheObservationWithTheMost) {
    EXPECT_EQ(common_decimals({4.99, 5.012, 5.0}), 3);
    EXPECT_EQ(common_decimals({210, 220}), 0);
    EXPECT_EQ(common_decimals({-0.5, 12.25}), 2);
    EXPECT_EQ(common_decimals({}), -1);
    EXPECT_EQ(common_decimals({1.0 / 3.0, 0.5}), -1) << "computed";
    EXPECT_EQ(common_decimals({2.5e-6, 3e-6}), -1) << "with powers of ten";
    EXPECT_EQ(common_decimals({6e-5, 0.000111}), 6) << "one of them would have a power of ten";
}

TEST(FormatExact, ReadsBackToTheSameNumber) {
    for (const double value :
         {0.1, 1.0 / 3.0, 1174.9091234567891, 5e-324, -0.0, 1e300, 123456789012345680.0}) {
        const double back = std::strtod(format_exact(value).c_str(), nullptr);
        EXPECT_EQ(back, value) << format_exact(value);
    }
    EXPECT_EQ(format_exact(0.1), "0.1");
    EXPECT_EQ(format_exact(inf), "inf");
}

TEST(TypesetNumber, HasATrueMinusPowersOfTenAndTheDecimalSignOfTheLocale) {
    EXPECT_EQ(typeset_number("-2.3e-05"), "−2.3×10⁻⁵");
    EXPECT_EQ(typeset_number("1.5e+12\u00a0mm"), "1.5×10¹²\u00a0mm");
    EXPECT_EQ(typeset_number("0.066"), "0.066");
    EXPECT_EQ(typeset_number("-0.066", {",", "."}), "−0,066");
    EXPECT_EQ(typeset_number("-∞"), "−∞");
}

TEST(GroupedNumber, FromTenThousandOn) {
    EXPECT_EQ(grouped_number(-0.25, 2), "−0.25");
    EXPECT_EQ(grouped_number(-0.001, 2), "0.00");
    EXPECT_EQ(grouped_number(1234.5, 1), "1234.5");
    EXPECT_EQ(grouped_number(9999, 0), "9999");
    EXPECT_EQ(grouped_number(1234567.0, 0), "1\u202f234\u202f567");
    EXPECT_EQ(grouped_number(-1234567.5, 1), "−1\u202f234\u202f567.5");
    EXPECT_EQ(grouped_number(-12345.5, 1, {",", "."}), "−12.345,5");
    EXPECT_EQ(grouped_number(inf, 0), "∞");
    EXPECT_EQ(count_text(1'000'000), "1\u202f000\u202f000");
}

TEST(GroupedDigits, OnBothSidesOfThePoint) {
    EXPECT_EQ(grouped_digits("50.00078"), "50.000\u202f78");
    EXPECT_EQ(grouped_digits("-1234567.891234"), "−1\u202f234\u202f567.891\u202f234");
    EXPECT_EQ(grouped_digits("1234.5678"), "1234.5678");
    EXPECT_EQ(grouped_digits("12345.12345", {",", " "}), "12 345,123 45");
    EXPECT_EQ(grouped_digits("2.3e-05"), "2.3×10⁻⁵");
    EXPECT_EQ(grouped_digits("-0.00035 rad", {",", " "}), "−0,000 35 rad") << "with its unit";
    EXPECT_EQ(grouped_digits("1.15275e-05"), "1.152\u202f75×10⁻⁵");
    EXPECT_EQ(grouped_digits("∞"), "∞");
}

TEST(PercentText, HasTheDecimalsThatItNeeds) {
    EXPECT_EQ(percent_text(0.95), "95\u00a0%");
    EXPECT_EQ(percent_text(0.9973), "99.73\u00a0%");
}

TEST(ShortTexts, OfFieldsAndMessages) {
    EXPECT_EQ(format_shortest(0.1), "0.1");
    EXPECT_EQ(format_shortest(123456789.5), "123456789.5");
    EXPECT_EQ(format_shortest(1e-5), "1e-05");
    EXPECT_EQ(format_short(0.012345), "0.0123");
    EXPECT_EQ(format_short(152345.0, 2), "1.5e+05");
    EXPECT_EQ(format_trimmed(0.5, 6), "0.5");
}

TEST(ProbabilityText, IsNeverRoundedToNoneOrAll) {
    EXPECT_EQ(probability_text(0.95), "95\u00a0%");
    EXPECT_EQ(probability_text(0.9545), "95.45\u00a0%");
    EXPECT_EQ(probability_text(0.9995), "99.95\u00a0%");
    EXPECT_EQ(probability_text(0.9999), "99.99\u00a0%");
    EXPECT_EQ(probability_text(0.99996), "> 99.99\u00a0%");
    EXPECT_EQ(probability_text(1.0 - 1e-15, {","}), "> 99,99\u00a0%");
    EXPECT_EQ(probability_text(1.0), "100\u00a0%");
    EXPECT_EQ(probability_text(3e-5), "< 0.01\u00a0%");
    EXPECT_EQ(probability_text(0.0), "0\u00a0%");
}

}  // namespace
}  // namespace covaria::numbers_test
