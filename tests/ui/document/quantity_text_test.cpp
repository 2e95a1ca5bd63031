// Quantities as typed and shown.
#include "ui/document/quantity_text.h"

#include <gtest/gtest.h>

#include "ui/theme/strings.h"

namespace covaria::ui::quantity_text_test {
namespace {

const QLocale english(QLocale::English, QLocale::UnitedKingdom);
const QLocale german(QLocale::German, QLocale::Germany);

Quantity parsed(const QString& text, const char* unit, const QLocale& locale = english) {
    const auto result = parse_quantity(text, Unit::of(unit), locale);
    EXPECT_TRUE(result && *result) << to_std(text);
    return result && *result ? **result : Quantity{};
}

TEST(QuantityText, KeepsTheUnitThatWasTyped) {
    const Quantity quantity = parsed("0.5 um", "mm");
    EXPECT_EQ(quantity.value, 0.5);
    EXPECT_EQ(quantity.unit.text(), "um");
}

TEST(QuantityText, ANumberAloneIsInTheFieldsUnit) {
    EXPECT_EQ(parsed("-3", "mm"), (Quantity{-3.0, Unit::of("mm")}));
    EXPECT_EQ(parsed("1e-3", "mm").value, 1e-3);
    EXPECT_EQ(parsed("12mm", "m").unit.text(), "mm");
}

TEST(QuantityText, DigitsMayStandInGroups) {
    EXPECT_EQ(parsed("1.000 25 V", "V").value, 1.00025);
    EXPECT_EQ(parsed("-12 345.678 9 mm", "mm").value, -12345.6789);
    EXPECT_EQ(parsed("10 000", "mm").value, 10000.0);
    EXPECT_EQ(parsed("0,000 005 mm", "mm", german).value, 5e-6);
    EXPECT_EQ(parsed("1.234 567e3 mm", "mm").value, 1234.567);
    EXPECT_EQ(parsed("1234.5 mm", "mm").value, 1234.5);
    EXPECT_EQ(parsed("0.125 1/K", "1/K"), (Quantity{0.125, Unit::of("1/K")}));
    EXPECT_EQ(parsed("0.000 011 1/K", "1/K").value, 0.000011);
    EXPECT_EQ(parsed("0.125 1", "1").value, 0.125) << "of unit one";
    EXPECT_EQ(parsed("50.000 1 mm", "mm").value, 50.0001);
    EXPECT_FALSE(parse_number("100 200 300", english)) << "of a list";
    for (const char* wrong : {"1.00 25 mm", "12 34 mm", "1 2", "1.2.3", "10 mm 000", "1.5 300.5 mm"})
        EXPECT_FALSE(parse_quantity(wrong, Unit::of("mm"), english)) << wrong;
}

TEST(QuantityText, ReadsTheDecimalMarkOfTheLocale) {
    EXPECT_EQ(parsed("1,5", "mm", german).value, 1.5);
    EXPECT_EQ(parsed("1.5", "mm", german).value, 1.5);
    EXPECT_FALSE(parse_quantity("1,5", Unit::of("mm"), english));
    EXPECT_FALSE(parse_quantity("1.234,5", Unit::of("mm"), german)) << "grouping is not guessed at";
}

TEST(QuantityText, SaysHowANumberOfAnotherLanguageIsTyped) {
    const auto refusal = [](const char* text, const QLocale& locale) {
        const auto read = parse_quantity(text, Unit::of("mm"), locale);
        return read ? std::string("read") : read.error().message.english();
    };
    EXPECT_EQ(refusal("1,5", english), "“1,5” is not a number. Type it as 1.5.");
    EXPECT_EQ(refusal("-1,5 mm", english), "“-1,5 mm” is not a number. Type it as -1.5 mm.");
    EXPECT_EQ(refusal("1,234 mm", english),
              "“1,234 mm” is not a number. Type it as 1.234 mm, or as 1234 mm.");
    for (const char* text : {"1,234,5", "one", "1.2,3"})
        EXPECT_EQ(refusal(text, english).find("Type it"), std::string::npos) << text;
    EXPECT_EQ(refusal("1.234,5", german).find("Type it"), std::string::npos);
}

TEST(QuantityText, ReadsPowersOfTenAsTheyAreShown) {
    EXPECT_EQ(parsed(QString::fromUtf8("−6,1×10⁻⁵ mm"), "mm", german).value, -6.1e-5);
    EXPECT_EQ(parsed(QString::fromUtf8("2×10⁷"), "mm").value, 2e7);
    EXPECT_EQ(with_plain_exponent(QString::fromUtf8("6.1×10⁻⁵")), "6.1e-5");
    EXPECT_EQ(with_plain_exponent("12"), "12");
    EXPECT_FALSE(parse_number(QString::fromUtf8("2×10"), english));
    EXPECT_FALSE(parse_number(QString::fromUtf8("2×10⁷x"), english));
}

TEST(QuantityText, ReadsSignsOfOtherPrograms) {
    EXPECT_EQ(parsed(QString::fromUtf8("−2 µm"), "mm").value, -2.0);
    EXPECT_EQ(parsed(QString::fromUtf8("20 °C"), "degC").unit.text(), Unit::of("degC").text());
    EXPECT_DOUBLE_EQ(parsed(QString::fromUtf8("180°"), "rad").si(), 3.14159265358979323846);
}

TEST(QuantityText, RefusesWithWords) {
    for (const char* text : {"abc", "5 kg", "5 parsnip", "1 2"}) {
        const auto refused = parse_quantity(text, Unit::of("mm"), english);
        ASSERT_FALSE(refused) << text;
        EXPECT_FALSE(refused.error().message.english().empty());
    }
    const auto empty = parse_quantity("  ", Unit::of("mm"), english);
    ASSERT_TRUE(empty);
    EXPECT_FALSE(empty->has_value());
}

TEST(QuantityText, WhatIsShownReadsBackToTheSameNumber) {
    for (const double value : {0.1, 1.0 / 3.0, -1234.5678, 6.02e23, 1e-9, 0.0, 123456789.0})
        for (const QLocale& locale : {english, german})
            EXPECT_EQ(parse_number(number_text(value, locale), locale), value)
                << to_std(number_text(value, locale));
    EXPECT_EQ(quantity_text({1.5, Unit::of("mm")}, german), "1,5 mm");
    EXPECT_EQ(quantity_text({2.0, Unit()}, english), "2");
}

TEST(QuantityText, ConversionLeavesNoNoise) {
    EXPECT_EQ(converted(0.5, Unit::of("um"), Unit::of("mm")), 0.0005);
    EXPECT_EQ(converted(0.7, Unit::of("mm"), Unit::of("um")), 700.0);
}

TEST(ConciseText, HasTheUncertaintyOfTheLastDigits) {
    const auto parts = [](const char* text) {
        const auto found = concise_parts(QString::fromUtf8(text));
        return found ? to_std(found->value + QLatin1String(" | ") + found->uncertainty) : "none";
    };
    EXPECT_EQ(parts("100.021 47(35) g"), "100.02147 g | 0.00035 g");
    EXPECT_EQ(parts("100.02147(0.00035) g"), "100.02147 g | 0.00035 g");
    EXPECT_EQ(parts("100,02147(35) g"), "100,02147 g | 0,00035 g");
    EXPECT_EQ(parts("-1.5(12)"), "-1.5 | 1.2");
    EXPECT_EQ(parts("50(2) mm"), "50 mm | 2 mm");
    EXPECT_EQ(parts("6.62(3)e-34 J s"), "6.62e-34 J s | 0.03e-34 J s");
    EXPECT_EQ(parts("2.0(1)×10⁻⁶"), "2.0×10⁻⁶ | 0.1×10⁻⁶");
    for (const char* text : {"100", "100 (g)", "f(2)", "1.2(3", "(3)", "1.2()", "1(2)(3)"})
        EXPECT_EQ(parts(text), "none") << text;
}

}  // namespace
}  // namespace covaria::ui::quantity_text_test
