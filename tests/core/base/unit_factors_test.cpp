// Every unit against a table of its own: the SI brochure (9th edition, tables 2 to 4, 7 and 8), ISO 80000 and
// the definitions of the inch and the pound (1959), written down without looking at the program's.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/base/unit_table.h"

namespace covaria::unit_factors_test {
namespace {

struct Definition {
    const char* unit;
    double factor;
    const char* in_base_units;
};

const double turn = 2.0 * 3.141592653589793;

const Definition definitions[] = {{"km", 1e3, "m"},
                                  {"pm", 1e-12, "m"},
                                  {"in", 0.0254, "m"},
                                  {"ft", 0.3048, "m"},
                                  {"yd", 0.9144, "m"},
                                  {"thou", 2.54e-5, "m"},
                                  {"mil", 2.54e-5, "m"},
                                  {"uin", 2.54e-8, "m"},
                                  {"au", 149597870700.0, "m"},
                                  {"ha", 1e4, "m^2"},
                                  {"degR", 5.0 / 9.0, "K"},
                                  {"L", 1e-3, "m^3"},
                                  {"l", 1e-3, "m^3"},
                                  {"mL", 1e-6, "m^3"},
                                  {"ml", 1e-6, "m^3"},
                                  {"hL", 0.1, "m^3"},
                                  {"deg", turn / 360, "rad"},
                                  {"arcmin", turn / 21600, "rad"},
                                  {"arcsec", turn / 1296000, "rad"},
                                  {"mas", turn / 1296e6, "rad"},
                                  {"gon", turn / 400, "rad"},
                                  {"mgon", turn / 4e5, "rad"},
                                  {"rev", turn, "rad"},
                                  {"sr", 1, "rad^2"},
                                  {"rpm", turn / 60, "rad/s"},
                                  {"min", 60, "s"},
                                  {"h", 3600, "s"},
                                  {"d", 86400, "s"},
                                  {"day", 86400, "s"},
                                  {"us", 1e-6, "s"},
                                  {"Hz", 1, "1/s"},
                                  {"GHz", 1e9, "1/s"},
                                  {"Bq", 1, "1/s"},
                                  {"kBq", 1e3, "1/s"},
                                  {"g", 1e-3, "kg"},
                                  {"ug", 1e-9, "kg"},
                                  {"Mg", 1e3, "kg"},
                                  {"t", 1e3, "kg"},
                                  {"kt", 1e6, "kg"},
                                  {"lb", 0.45359237, "kg"},
                                  {"Da", 1.66053906660e-27, "kg"},
                                  {"N", 1, "kg*m/s^2"},
                                  {"lbf", 4.4482216152605, "kg*m/s^2"},
                                  {"Pa", 1, "kg/(m*s^2)"},
                                  {"bar", 1e5, "kg/(m*s^2)"},
                                  {"mbar", 100, "kg/(m*s^2)"},
                                  {"psi", 6894.757293168361, "kg/(m*s^2)"},
                                  {"J", 1, "kg*m^2/s^2"},
                                  {"eV", 1.602176634e-19, "kg*m^2/s^2"},
                                  {"keV", 1.602176634e-16, "kg*m^2/s^2"},
                                  {"W", 1, "kg*m^2/s^3"},
                                  {"C", 1, "A*s"},
                                  {"V", 1, "kg*m^2/(s^3*A)"},
                                  {"F", 1, "s^4*A^2/(kg*m^2)"},
                                  {"pF", 1e-12, "s^4*A^2/(kg*m^2)"},
                                  {"ohm", 1, "kg*m^2/(s^3*A^2)"},
                                  {"Mohm", 1e6, "kg*m^2/(s^3*A^2)"},
                                  {"S", 1, "s^3*A^2/(kg*m^2)"},
                                  {"Wb", 1, "kg*m^2/(s^2*A)"},
                                  {"T", 1, "kg/(s^2*A)"},
                                  {"mT", 1e-3, "kg/(s^2*A)"},
                                  {"H", 1, "kg*m^2/(s^2*A^2)"},
                                  {"uH", 1e-6, "kg*m^2/(s^2*A^2)"},
                                  {"lm", 1, "cd*rad^2"},
                                  {"lx", 1, "cd*rad^2/m^2"},
                                  {"mcd", 1e-3, "cd"},
                                  {"Gy", 1, "m^2/s^2"},
                                  {"mSv", 1e-3, "m^2/s^2"},
                                  {"kat", 1, "mol/s"},
                                  {"mmol", 1e-3, "mol"},
                                  {"mK", 1e-3, "K"},
                                  {"%", 1e-2, "1"},
                                  {"ppm", 1e-6, "1"},
                                  {"ppb", 1e-9, "1"},
                                  {"W/(m*K)", 1, "kg*m/(s^3*K)"},
                                  {"W/(m K)", 1, "kg*m/(s^3*K)"},
                                  {"uV/V", 1e-6, "1"},
                                  {"mol/L", 1e3, "mol/m^3"},
                                  {"(m/s)^2", 1, "m^2/s^2"},
                                  {"kW*h", 3.6e6, "kg*m^2/s^2"},
                                  {"g/cm^3", 1e3, "kg/m^3"}};

TEST(UnitFactors, AgreeWithTheDefinitions) {
    for (const Definition& d : definitions) {
        const Result<Unit> unit = Unit::parse(d.unit);
        ASSERT_TRUE(unit) << d.unit << ": " << unit.error().message.english();
        EXPECT_EQ(unit->dimension(), Unit::of(d.in_base_units).dimension()) << d.unit;
        EXPECT_NEAR(unit->to_si(1.0), d.factor, 2e-15 * d.factor) << d.unit;
        EXPECT_NEAR(unit->interval_from_si(d.factor), 1.0, 2e-15) << d.unit;
    }
}

// No unit of the table is without a definition above or a prefix of one.
TEST(UnitFactors, EveryUnitIsDefined) {
    std::set<std::string> defined{"1", "m", "rad", "K", "degC", "degF", "s", "kg", "A", "mol", "cd"};
    for (const Definition& d : definitions) defined.insert(d.unit);
    for (const detail::UnitEntry& unit : detail::unit_table()) {
        const bool known = defined.contains(std::string(unit.name)) ||
                           std::any_of(defined.begin(), defined.end(), [&](const std::string& name) {
                               return unit.prefixes != detail::Prefixes::none &&
                                      name.size() > unit.name.size() && name.ends_with(unit.name);
                           });
        EXPECT_TRUE(known) << unit.name;
    }
}

TEST(UnitFactors, PrefixesArePowersOfTen) {
    const std::map<std::string, int> powers{
        {"Q", 30}, {"R", 27},  {"Y", 24},  {"Z", 21},  {"E", 18},  {"P", 15},  {"T", 12},  {"G", 9},
        {"M", 6},  {"k", 3},   {"h", 2},   {"da", 1},  {"d", -1},  {"c", -2},  {"m", -3},  {"u", -6},
        {"n", -9}, {"p", -12}, {"f", -15}, {"a", -18}, {"z", -21}, {"y", -24}, {"r", -27}, {"q", -30}};
    for (const detail::UnitEntry& unit : detail::unit_table()) {
        if (unit.prefixes != detail::Prefixes::all) continue;
        for (const auto& [prefix, power] : powers) {
            const std::string name = prefix + std::string(unit.name);
            if (name == "min" || name == "cd" || name == "Gy") continue;  // units of their own
            const Result<Unit> found = Unit::parse(name);
            ASSERT_TRUE(found) << name;
            const double one = Unit::of(unit.name).to_si(1.0);
            EXPECT_NEAR(found->to_si(1.0) / one, std::pow(10.0, power), 3e-15 * std::pow(10.0, power))
                << name;
        }
    }
}

TEST(UnitFactors, AllNamesAndDisplaysAreReadBack) {
    for (const detail::KnownUnit& known : detail::all_units()) {
        const Unit unit = Unit::of(known.name);
        EXPECT_EQ(unit.text(), known.name);
        EXPECT_EQ(Unit::of(unit.display()), unit) << known.name;
        EXPECT_EQ(unit.interval().dimension(), unit.dimension());
        EXPECT_FALSE(unit.interval().has_offset());
        EXPECT_EQ(unit.interval().interval_to_si(3.5), unit.interval_to_si(3.5)) << known.name;
    }
}

TEST(UnitFactors, ParenthesesAndPowers) {
    EXPECT_EQ(Unit::of("W/(m K)").text(), "W/(m*K)");
    EXPECT_EQ(Unit::of("W/m/K"), Unit::of("W/(m*K)"));
    EXPECT_EQ(Unit::of("W/(m*K)").display(), "W/(m·K)");
    EXPECT_EQ(Unit::of("1/(m*s)^2").text(), "1/(m^2*s^2)");
    EXPECT_EQ(Unit::of("(kg*m/s^2)/(A*m)").text(), "kg*m/(s^2*A*m)");
    EXPECT_EQ(Unit::of("m/(s/K)").text(), "m*K/s");
    for (const char* text :
         {"W/(m*K", "W/m*K)", "()", "W/()", "W/m K", "(m)(s)", "((((((((m^9)^9)^9)^9)^9)^9)^9)^9)"})
        EXPECT_FALSE(Unit::parse(text)) << text;
}

TEST(UnitFactors, WordsGetTheirSymbolsSuggested) {
    for (const auto& [word, symbol] : std::map<std::string, std::string>{{"millimetres", "mm"},
                                                                         {"Meter", "m"},
                                                                         {"kilonewton", "kN"},
                                                                         {"micrometer", "um"},
                                                                         {"celsius", "degC"},
                                                                         {"Volts", "V"},
                                                                         {"feet", "ft"},
                                                                         {"henry", "H"}}) {
        const Result<Unit> unit = Unit::parse(word);
        ASSERT_FALSE(unit) << word;
        EXPECT_NE(unit.error().message.english().find("Did you mean \"" + symbol + "\"?"), std::string::npos)
            << unit.error().message.english();
    }
}

}  // namespace
}  // namespace covaria::unit_factors_test
