// Budgets of others: GUM Workbench and Suncal.
#include <cmath>

#include "core/kinds/registries.h"
#include "tests/core/readers/reading.h"

namespace covaria::budgets_test {

using namespace readers_test;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

struct Refusal {
    std::string text;
    int line;
    const char* words;
};

void expect_refused(const std::string& reader, const std::vector<Refusal>& cases) {
    for (const Refusal& c : cases) {
        const auto read = read_with(reader, c.text);
        ASSERT_FALSE(read) << c.words;
        EXPECT_EQ(read.error().line, c.line) << c.words;
        EXPECT_NE(read.error().message.english().find(c.words), std::string::npos)
            << read.error().message.english();
    }
}

TEST(ReadGumWorkbench, TheBudgetGivesWhatTheFileStates) {
    const auto read = read_with("gum-workbench", data("mass.smu"), {.file_name = "mass.smu"});
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    EXPECT_EQ(read->title, "Mass of a weight");
    const OutputResult m = first_order(*read).outputs.at(0);
    EXPECT_NEAR(m.estimate, 10.000025, 1e-12);
    // (22.5² + 15²/3 + 14.4² + 2 · 10²/3) mg²
    EXPECT_NEAR(m.standard_uncertainty, std::sqrt(22.5 * 22.5 + 75.0 + 14.4 * 14.4 + 200.0 / 3.0) * 1e-6,
                1e-15);
    EXPECT_NE(all_found(*read).find("Ustd = 0.0291465"), std::string::npos) << all_found(*read);
    EXPECT_NE(all_found(*read).find("section [Window]"), std::string::npos);
    EXPECT_EQ((*reader_for(data("mass.smu"), "mass.smu"))->name, "gum-workbench");
}

TEST(ReadGumWorkbench, WhatIsNotKnownHasAPlace) {
    const std::string file = data("mass.smu");
    expect_refused("gum-workbench",
                   {{replaced(file, "Type=TypBRectang", "Type=TypBTrapez"), 45, "'TypBTrapez'"},
                    {replaced(file, "Uexp=0.045", "Uexp=0,045"), 41, "Uexp '0,045' is no number"},
                    {replaced(file, "Hlim=0.015\n", ""), 44, "Hlim= is missing"},
                    {replaced(file, "[COMP 6]", "[COMP 7]"), 23, "[COMP 6] is missing"},
                    {replaced(file, "m_X = m_S", "m_X = m_S +* log(2)"), 14, "log may be"},
                    {replaced(file, "m_X = m_S", "m_X = m_S + * m_S"), 14, "column"},
                    {replaced(file, "[Window]", "[Header]"), 73, "stands twice"}});
}

TEST(ReadSuncal, StatementsUnitsAndCorrelationsAreTaken) {
    const auto read = read_with("suncal", data("resistor.yaml"));
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->analyses.size(), 1u);
    const AnalysisEntry& analysis = read->analyses[0];
    const SetupSchema& schema = find_model(analysis.model)->schema;
    const auto at = [&](std::size_t row, const char* column) {
        return cell(schema, analysis.setup, "quantities", row, column);
    };
    EXPECT_EQ(at(1, "statement"), SetupCell(std::string("certificate-k")));
    EXPECT_EQ(at(1, "a"), SetupCell(0.002 * 4.999)) << "0.2% of the mean";
    EXPECT_EQ(at(2, "unit"), SetupCell(std::string("mV")));
    EXPECT_EQ(at(4, "b"), SetupCell(95.0)) << "conf = 0.95";
    EXPECT_EQ(at(4, "nu"), SetupCell(4.0));
    ASSERT_EQ(analysis.correlations.size(), 1u);
    EXPECT_DOUBLE_EQ(analysis.correlations[0].coefficient, -0.36);
    EXPECT_NE(all_found(*read).find("31 mode 'risk'"), std::string::npos) << all_found(*read);
    EXPECT_NEAR(first_order(*read).outputs.at(0).estimate, 4.999 / 0.019661, 1e-9);
}

/// A system as Suncal writes it, with units that Covaria does not have.
const char* const pitot_system =
    "- mode: system\n  name: system\n  correlate: true\n  quantities:\n"
    "  - {type: indirect, symbol: v, equation: sqrt(2)*sqrt(D*R*T/p), units: meter / second}\n"
    "  - {type: direct, symbol: D, testpoint: 8.0, units: inch_H2O, typea: null,\n"
    "     typeb: [{dist: normal, k: 2.0, unc: 0.1, units: inch_H2O, degf: .inf}]}\n"
    "  - {type: direct, symbol: R, testpoint: 287.06, units: joule / kelvin / kilogram, typeb: []}\n"
    "  - {type: direct, symbol: T, testpoint: 67.4, units: degree_Fahrenheit,\n"
    "     typeb: [{dist: normal, k: 2.0, unc: 0.2, units: delta_degree_Fahrenheit}]}\n"
    "  - {type: direct, symbol: p, testpoint: 14.7, units: pound_force_per_square_inch,\n"
    "     typeb: [{dist: normal, k: 2.0, unc: 0.3, units: pound_force_per_square_inch}]}\n"
    "  - {type: direct, symbol: w, testpoint: 3.0, units: volts, typeb: []}\n";

TEST(ReadSuncal, ASystemIsOneModel) {
    const auto read = read_with("suncal", pitot_system);
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    const UncertaintyResult result = first_order(*read);
    ASSERT_EQ(result.outputs.size(), 2u) << "the airspeed, and w, which no equation uses";
    // Independently: inch of water 249.08891 Pa, psi 6894.757293168 Pa, (67.4 °F - 32) 5/9 + 273.15 K
    EXPECT_NEAR(result.outputs[0].estimate, 57.49145038400207, 1e-10);
    EXPECT_NEAR(result.outputs[0].standard_uncertainty, 0.3440153339205798, 1e-11);
    EXPECT_NE(all_found(*read).find("'D': 8 inch_H2O is 1992.71128 Pa"), std::string::npos)
        << all_found(*read);
}

TEST(ReadSuncal, ObservationsOfASystemAreTypeAAndCorrelated) {
    const auto read = read_with(
        "suncal",
        "- mode: system\n  quantities:\n"
        "  - {type: direct, symbol: V, testpoint: 5.0, units: volt, typea: [5.007,4.994,5.005,4.990,4.999],\n"
        "     typeb: [{dist: uniform, a: 0.001, units: volt}]}\n"
        "  - {type: direct, symbol: I, testpoint: 19.6, units: milliampere,\n"
        "     typea: [19.663,19.639,19.640,19.685,19.678]}\n"
        "  - {type: indirect, symbol: R, equation: V/I, units: ohm}\n");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    const OutputResult r = first_order(*read).outputs.at(0);
    EXPECT_NEAR(r.estimate, 254.2597019480189, 1e-9);
    EXPECT_NEAR(r.standard_uncertainty, 0.23815348948850232, 1e-11);
}

TEST(ReadSuncal, FiguresMayBeShares) {
    const auto read = read_with(
        "suncal",
        "- functions: [{name: f, expr: f = A*B/C}]\n  inputs:\n"
        "  - {name: A, mean: -32.0, uncerts: [{dist: normal, unc: .01% + .00001*100, units: null}]}\n"
        "  - {name: B, mean: 2.0, typea: [1.9, 2.1, 2.0], numnewmeas: 1,\n"
        "     uncerts: [{dist: normal, unc: 10 ppm + .01%range(10), k: '2'}]}\n"
        "  - {name: C, mean: 100.0, typea_uncert: 0.5, uncerts: [{dist: poisson, v: '81', k: 2, unc: 1}]}\n");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    const AnalysisEntry& analysis = read->analyses.at(0);
    const SetupSchema& schema = find_model(analysis.model)->schema;
    const auto a = [&](std::size_t row) {
        return std::get<double>(cell(schema, analysis.setup, "quantities", row, "a"));
    };
    EXPECT_DOUBLE_EQ(a(0), 0.0032 + 0.001);
    EXPECT_NEAR(a(2), 0.1, 1e-15) << "s of the observations, one new reading";
    EXPECT_DOUBLE_EQ(a(3), 0.00002 + 0.001);
    EXPECT_DOUBLE_EQ(a(5), 0.5);
    EXPECT_DOUBLE_EQ(a(6), 9.0) << "counts";
    EXPECT_EQ(read->unstated.size(), 3u);
}

TEST(ReadSuncal, ImplicitFunctionsAreSolved) {
    const std::string file =
        "- functions: [{name: p, expr: '-p + F/(A*(1 + l*p)) = 0; p~41000.0', units: pascal}]\n  inputs:\n"
        "  - {name: F, mean: 13.7, units: newton}\n  - {name: A, mean: 0.000335, units: meter ** 2}\n"
        "  - {name: l, mean: 4.0e-06, units: 1 / pascal}\n";
    const auto read = read_with("suncal", file);
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    const double b = 13.7 / 0.000335;  // 4e-6 p² + p = b
    EXPECT_NEAR(first_order(*read).outputs.at(0).estimate, (std::sqrt(1.0 + 16e-6 * b) - 1.0) / 8e-6, 1e-6);
    expect_refused("suncal", {{replaced(file, ", units: pascal}]", "}]"), 1, "state the unit"}});
}

// Differences of temperatures in the functions that others have typed.
TEST(ReadSuncal, DifferencesOfTemperaturesAreInKelvin) {
    const auto with = [](const std::string& units) {
        return "- functions: [{name: L, expr: 'L_0*(1 + a*t)', units: mm}]\n  inputs:\n"
               "  - {name: L_0, mean: 1000, units: mm}\n  - {name: a, mean: 1.0e-05, units: 1 / kelvin}\n"
               "  - {name: t, mean: 20, units: " +
               units + "}\n";
    };
    for (const auto& [unit, kelvin] :
         {std::pair("kelvin", 20.0), {"delta_degC", 20.0}, {"delta_degF", 20.0 / 1.8}}) {
        const auto read = read_with("suncal", with(unit));
        ASSERT_TRUE(read) << read.error().message.english();
        EXPECT_EQ(errors_of(*read), "") << unit;
        EXPECT_NEAR(first_order(*read).outputs.at(0).estimate, 1.0 + 1e-5 * kelvin, 1e-12) << unit;
    }
}

TEST(ReadSuncal, WhatASystemDoesNotSayIsRefused) {
    const std::string file = pitot_system;
    expect_refused("suncal",
                   {{replaced(file, "type: indirect", "type: curve"), 5, "quantities of type 'curve'"},
                    {replaced(file, "typea: null", "typea: [[1, 2], [3, 4]]"), 6, "in groups"},
                    {replaced(file, "typea: null", "typea: [1]"), 6, "at least two"},
                    {replaced(file, "testpoint: 8.0", "testpoint: x"), 6, "must be a number"},
                    {replaced(file, "unc: 0.1", "unc: 0.1*(1+"), 7, "is no number"},
                    {replaced(file, "unc: 0.1", "unc: " + std::string(150, '(')), 7, "is no number"},
                    {replaced(file, "inch_H2O", "furlong"), 6, "furlong"}});
}

TEST(ReadSuncal, BombsAndContradictionsHaveAPlace) {
    const std::string file = data("resistor.yaml");
    std::string deep = "- ";
    for (int i = 0; i < 5000; ++i) deep += "[";
    expect_refused("suncal",
                   {{"a: &a [x, x]\nb: &b [*a, *a]\n", 2, "aliases are not expanded"},
                    {deep, 1, "levels"},
                    {std::string(600'000, '['), 1, "more than 500 kB"},
                    {"- mode: risk\n", 1, "it has mode 'risk'"},
                    {replaced(file, "mean: 4.999", "mean: five"), 8, "its mean must be a number"},
                    {replaced(file, "dist: triangular", "dist: gamma"), 23, "the distribution 'gamma'"},
                    {replaced(file, "units: volt\n", "units: volts_per_furlong\n"), 9, "is not known"},
                    {replaced(file, "V/I*(1", "V/I*(1 */"), 5, "column"},
                    {replaced(file, "cor: -0.36", "cor: -1.36"), 29, "between -1 and 1"},
                    {replaced(file, "name: I\n", "name: V\n"), 14, "two inputs of that name"},
                    {"a: 1\na: 2\n", 2, "stands twice"},
                    {"a: [1\n", 2, "not readable as YAML"}});
}

}  // namespace

}  // namespace covaria::budgets_test
