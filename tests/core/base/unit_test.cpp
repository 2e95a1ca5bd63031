// Units: factors, compounds, signs, round trips, and what is refused.
#include "core/base/unit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/base/unit_table.h"

namespace covaria::unit_test {
namespace {

std::string message_of(std::string_view text) {
    const Result<Unit> unit = Unit::parse(text);
    EXPECT_FALSE(unit.has_value()) << text;
    return unit ? std::string() : unit.error().message.english();
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

TEST(Unit, ConvertsToTheNearestDouble) {
    EXPECT_EQ(Unit::of("mm").to_si(0.066), 6.6e-5);
    EXPECT_EQ(Unit::of("um").to_si(1.3), 1.3e-6);
    EXPECT_EQ(Unit::of("um/m").to_si(11.5), 11.5e-6);
    EXPECT_EQ(Unit::of("mm^2").to_si(7.0), 7e-6);
    EXPECT_EQ(Unit::of("1/K").to_si(1.15e-5), 1.15e-5);
    EXPECT_EQ(Unit::of("mV/V").to_si(2.0), 0.002);
    EXPECT_EQ(Unit::of("hPa").to_si(1013.25), 101325.0);
    EXPECT_EQ(Unit::of("km/h").to_si(36.0), 10.0);
    EXPECT_EQ(Unit::of("1").to_si(-0.25), -0.25);
}

TEST(Unit, AnglesAreFractionsOfPi) {
    EXPECT_EQ(Unit::of("deg").to_si(180.0), std::numbers::pi);
    EXPECT_EQ(Unit::of("gon").to_si(200.0), std::numbers::pi);
    EXPECT_DOUBLE_EQ(Unit::of("arcmin").to_si(180.0 * 60.0), std::numbers::pi);
    EXPECT_DOUBLE_EQ(Unit::of("arcsec").to_si(180.0 * 3600.0), std::numbers::pi);
    EXPECT_EQ(Unit::of("mgon").from_si(std::numbers::pi), 200000.0);
    EXPECT_NE(Unit::of("deg").dimension(), Unit::of("1").dimension());
    EXPECT_NE(Unit::of("deg").dimension(), Unit::of("mm").dimension());
}

TEST(Unit, FahrenheitHasAnIntervalOfItsOwn) {
    const Unit fahrenheit = Unit::of("°F");
    EXPECT_EQ(fahrenheit, Unit::of("degF"));
    EXPECT_EQ(fahrenheit, Unit::of("℉"));
    for (const auto& [f, k] : {std::pair(-459.67, 0.0), {32.0, 273.15}, {68.0, 293.15}, {212.0, 373.15}}) {
        EXPECT_NEAR(fahrenheit.to_si(f), k, 1e-12);
        EXPECT_NEAR(fahrenheit.from_si(k), f, 1e-12);
    }
    EXPECT_TRUE(fahrenheit.has_offset());
    EXPECT_EQ(fahrenheit.interval(), Unit::of("degR"));
    EXPECT_FALSE(Unit::of("degR").has_offset());
    EXPECT_DOUBLE_EQ(fahrenheit.interval().to_si(9.0), 5.0);
    EXPECT_DOUBLE_EQ(Unit::of("1/degF").to_si(5.0), 9.0);
}

TEST(Unit, CelsiusHasAnOffsetOnlyByItself) {
    const Unit celsius = Unit::of("degC");
    EXPECT_DOUBLE_EQ(celsius.to_si(20.0), 293.15);
    EXPECT_DOUBLE_EQ(celsius.from_si(293.15), 20.0);
    EXPECT_EQ(celsius.interval_to_si(0.5), 0.5);
    EXPECT_EQ(Unit::of("um/degC").to_si(3.0), 3e-6);
    EXPECT_EQ(Unit::of("1/degC").dimension(), Unit::of("1/K").dimension());
}

TEST(Unit, DerivedUnitsHaveTheDimensionsOfTheirDefinitions) {
    const auto same = [](std::string_view a, std::string_view b) {
        EXPECT_EQ(Unit::of(a).dimension(), Unit::of(b).dimension()) << a << " and " << b;
        EXPECT_NEAR(Unit::of(a).to_si(1.0), Unit::of(b).to_si(1.0), 1e-15) << a << " and " << b;
    };
    same("N", "kg*m/s^2");
    same("J", "N*m");
    same("W", "J/s");
    same("Pa", "N/m^2");
    same("V", "W/A");
    same("ohm", "V/A");
    same("Hz", "1/s");
    same("MPa", "N/mm^2");
    same("%", "cm/m");
    same("ppm", "um/m");
}

TEST(Unit, PowersAndQuotientsReadFromLeftToRight) {
    EXPECT_EQ(Unit::of("m/s2"), Unit::of("m/s^2"));
    EXPECT_EQ(Unit::of("m/s/s").dimension(), Unit::of("m/s^2").dimension());
    EXPECT_EQ(Unit::of("m*s^-2").dimension(), Unit::of("m/s^2").dimension());
    EXPECT_EQ(Unit::of("J/kg*K").dimension(), Unit::of("J*K/kg").dimension());
    EXPECT_EQ(Unit::of(" um / m ").text(), "um/m");
    EXPECT_TRUE(Unit::of("mV/V").dimension().is_one());
}

TEST(Unit, AcceptsSignsAndShowsThem) {
    EXPECT_EQ(Unit::of("\u00B5m"), Unit::of("um"));
    EXPECT_EQ(Unit::of("\u03BCm"), Unit::of("um"));
    EXPECT_EQ(Unit::of("\u00B0"), Unit::of("deg"));
    EXPECT_EQ(Unit::of("\u00B0C"), Unit::of("degC"));
    EXPECT_EQ(Unit::of("\u03A9"), Unit::of("ohm"));
    EXPECT_EQ(Unit::of("N\u00B7m"), Unit::of("N*m"));
    EXPECT_EQ(Unit::of("m\u00B7s\u207B\u00B2"), Unit::of("m*s^-2"));
    EXPECT_EQ(Unit::of("um/m").display(), "µm/m");
    EXPECT_EQ(Unit::of("deg").display(), "°");
    EXPECT_EQ(Unit::of("degC").display(), "°C");
    EXPECT_EQ(Unit::of("N*m").display(), "N·m");
    EXPECT_EQ(Unit::of("m/s2").display(), "m/s²");
    EXPECT_EQ(Unit::of("K^-1").display(), "K⁻¹");
    EXPECT_EQ(Unit::of("ohm").display(), "Ω");
    EXPECT_EQ(Unit().display(), "1");
}

TEST(Unit, EveryKnownUnitRoundTrips) {
    for (const detail::UnitEntry& entry : detail::unit_table()) {
        const Unit unit = Unit::of(entry.name);
        EXPECT_EQ(unit.text(), entry.name);
        EXPECT_EQ(Unit::of(unit.display()), unit) << entry.name;
        for (const double value : {0.066, -12.5, 1e-3, 734.25}) {
            const double offset = std::abs(unit.to_si(0.0));
            EXPECT_NEAR(unit.from_si(unit.to_si(value)), value, 4e-16 * (std::abs(value) + offset))
                << entry.name;
            EXPECT_NEAR(unit.interval_from_si(unit.interval_to_si(value)), value, 4e-16 * std::abs(value));
        }
    }
}

TEST(Unit, EqualUnitsAreWrittenAlike) {
    EXPECT_EQ(Unit::of(Unit::of("m/s2").text()).text(), "m/s^2");
    EXPECT_EQ((Quantity{1.0, Unit::of("mm")}), (Quantity{1.0, Unit::of("mm")}));
    EXPECT_NE((Quantity{1.0, Unit::of("mm")}), (Quantity{1.0, Unit::of("um")}));
    EXPECT_EQ((Quantity{250.0, Unit::of("um")}).si(), 250e-6);
}

TEST(Unit, NamesTheUnknownUnitAndSuggestsOthers) {
    EXPECT_TRUE(contains(message_of("micron"), "\"micron\" is not known"));
    EXPECT_TRUE(contains(message_of("arcsecs"), "Did you mean \"arcsec\""));
    EXPECT_TRUE(contains(message_of("MM"), "\"mm\""));
    EXPECT_TRUE(contains(message_of("um/Kelvin"), "\"Kelvin\""));
    EXPECT_TRUE(contains(message_of("pa"), "\"Pa\""));
    EXPECT_TRUE(contains(message_of("furlong"), ": 1 % ppm ppb m"));
}

TEST(Unit, RefusesWhatIsNoUnit) {
    EXPECT_TRUE(contains(message_of(""), "empty"));
    EXPECT_TRUE(contains(message_of("   "), "empty"));
    EXPECT_TRUE(contains(message_of("m s^-2"), "write a product with '*'"));  // not milliseconds
    EXPECT_TRUE(contains(message_of("mm/"), "missing"));
    EXPECT_TRUE(contains(message_of("*mm"), "missing"));
    EXPECT_TRUE(contains(message_of("m//s"), "missing"));
    EXPECT_TRUE(contains(message_of("m^"), "exponent"));
    EXPECT_TRUE(contains(message_of("m^0"), "exponent"));
    EXPECT_TRUE(contains(message_of("m^1.5"), "exponent"));
    EXPECT_TRUE(contains(message_of("m^99"), "exponent"));
    EXPECT_TRUE(contains(message_of("^2"), "not known"));
    EXPECT_TRUE(contains(message_of("10*m"), "numbers"));
    EXPECT_TRUE(contains(message_of(std::string(1000, 'm')), "too long"));
    std::string many = "m^9";
    for (int i = 0; i < 15; ++i) many += "*m^9";
    EXPECT_TRUE(contains(message_of(many), "exponents are too large"));
    EXPECT_FALSE(Unit::parse(std::string_view("m\0m", 3)).has_value());
    EXPECT_FALSE(Unit::parse("\xC2").has_value());
}

TEST(UnitDeathTest, LiteralsMustBeRight) {
    EXPECT_DEATH(Unit::of("milimeter"), "not known");
}

}  // namespace
}  // namespace covaria::unit_test
