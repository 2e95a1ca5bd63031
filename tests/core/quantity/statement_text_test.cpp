// Statements of uncertainty that people type into a cell of a budget.
#include "core/quantity/statement_text.h"

#include <gtest/gtest.h>

#include <charconv>
#include <map>

#include "core/quantity/statement.h"

namespace covaria::statement_text_test {
namespace {

const Unit nm = Unit::of("nm");

std::string plain(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

TypedStatement typed(std::string_view text, const Unit& unit = nm) {
    const auto read = read_statement(text, unit);
    EXPECT_TRUE(read) << text << ": " << (read ? "" : read.error().message.english());
    return read.value_or(TypedStatement{});
}
std::string objection(std::string_view text, const Unit& unit = nm) {
    const auto read = read_statement(text, unit);
    EXPECT_FALSE(read) << text;
    return read ? "" : read.error().message.english();
}

TEST(StatementText, IsReadAsPeopleNoteIt) {
    EXPECT_EQ(typed(""), TypedStatement{});
    EXPECT_EQ(typed("75"), (TypedStatement{"standard", 75.0}));
    EXPECT_EQ(typed("75 nm"), (TypedStatement{"standard", 75.0}));
    EXPECT_EQ(typed("75nm"), (TypedStatement{"standard", 75.0}));
    EXPECT_EQ(typed("u = 0.075 µm"), (TypedStatement{"standard", 0.075, {}, {}, "um"}));
    EXPECT_EQ(typed("25 nm nu 18"), (TypedStatement{"standard", 25.0, {}, 18.0}));
    EXPECT_EQ(typed("U = 75 nm, k = 3, nu = 18"), (TypedStatement{"certificate-k", 75.0, 3.0, 18.0}));
    EXPECT_EQ(typed("s = 13 nm, n = 5, nu 24"), (TypedStatement{"standard-deviation", 13.0, 5.0, 24.0}));
    EXPECT_EQ(typed("13 nm n=5"), (TypedStatement{"standard-deviation", 13.0, 5.0}));
    EXPECT_EQ(typed("75 nm k=3"), (TypedStatement{"certificate-k", 75.0, 3.0}));
    EXPECT_EQ(typed("75 nm, p = 95 %"), (TypedStatement{"certificate-p", 75.0, 95.0}));
    EXPECT_EQ(typed("U 75 95 %"), (TypedStatement{"certificate-p", 75.0, 95.0}));
    EXPECT_EQ(typed("cert 75; p=95%"), (TypedStatement{"certificate-p", 75.0, 95.0}));
    EXPECT_EQ(typed("rect 0.5"), (TypedStatement{"rectangular", 0.5}));
    EXPECT_EQ(typed("±0.5 um"), (TypedStatement{"rectangular", 0.5, {}, {}, "um"}));
    EXPECT_EQ(typed("+-0.5"), (TypedStatement{"rectangular", 0.5}));
    EXPECT_EQ(typed("tri ± 2"), (TypedStatement{"triangular", 2.0}));
    EXPECT_EQ(typed("trap 1 ratio 0.5"), (TypedStatement{"trapezoidal", 1.0, 0.5}));
    EXPECT_EQ(typed("limits -1 to 2"), (TypedStatement{"limits", -1.0, 2.0}));
    EXPECT_EQ(typed("−1 .. 2"), (TypedStatement{"limits", -1.0, 2.0}));
    EXPECT_EQ(typed("mpe 3 + 0.1 %"), (TypedStatement{"mpe", 3.0, 0.1}));
    EXPECT_EQ(typed("MPE 3"), (TypedStatement{"mpe", 3.0}));
    EXPECT_EQ(typed("counts 12"), (TypedStatement{"counts", 12.0}));
    EXPECT_EQ(typed("obs"), (TypedStatement{"observations"}));
    EXPECT_EQ(typed("Constant"), (TypedStatement{"constant"}));
    EXPECT_EQ(read_statement("rect 0,5", nm, true).value(), (TypedStatement{"rectangular", 0.5}));
    // The word may stand behind its figures.
    EXPECT_EQ(typed("0.5 rectangular"), (TypedStatement{"rectangular", 0.5}));
    EXPECT_EQ(typed("0.01 % rect", Unit::of("V")), (TypedStatement{"rectangular", 0.01, {}, {}, "%"}));
    EXPECT_EQ(typed("±0.5 um tri"), (TypedStatement{"triangular", 0.5, {}, {}, "um"}));
    EXPECT_EQ(typed("75 nm k = 3 cert"), (TypedStatement{"certificate-k", 75.0, 3.0}));
    EXPECT_NE(objection("rect 0.5 triangular"), "") << "two words";
    // Digits in groups, as results are written.
    EXPECT_EQ(typed("0.000 25 um"), (TypedStatement{"standard", 0.00025, {}, {}, "um"}));
    EXPECT_EQ(typed("U = 12 000 nm, k = 2"), (TypedStatement{"certificate-k", 12000.0, 2.0}));
    EXPECT_EQ(typed("limits -0.001 5 to 1 000.5"), (TypedStatement{"limits", -0.0015, 1000.5}));
    EXPECT_EQ(typed("0.000 011 1/K", Unit::of("1/K")), (TypedStatement{"standard", 0.000011}));
    EXPECT_EQ(typed("0.000 25 1/K", Unit::of("1/K")), (TypedStatement{"standard", 0.00025}));
    EXPECT_EQ(typed("u = 12\u202f500 nm"), (TypedStatement{"standard", 12500.0}));
    EXPECT_EQ(typed("s = 12 500 nm"), (TypedStatement{"standard-deviation", 12500.0}));
    EXPECT_EQ(typed("s = 0.000 25"), (TypedStatement{"standard-deviation", 0.00025}));
    EXPECT_EQ(typed("10 000; 10 001; 10 002").observations, (std::vector<double>{10000, 10001, 10002}));
    EXPECT_EQ(typed("100 101 102").observations.size(), 3u) << "a list is one";
    EXPECT_NE(objection("100 101"), "") << "two readings, or one number?";
    EXPECT_NE(objection("10.125 12"), "");
    EXPECT_NE(objection("1 00 nm"), "");
    EXPECT_EQ(typed("3 s", Unit::of("s")), (TypedStatement{"standard", 3.0})) << "a letter is a unit";
}

/// German words; "exp" is the beginning of an English and of a German word.
std::string in_german(const std::string& english) {
    static const std::map<std::string, std::string> words{{"rectangular", "rechteckig"},
                                                          {"limits", "Grenzen"},
                                                          {"to", "bis"},
                                                          {"trapezoidal", "trapezförmig"},
                                                          {"ratio", "Verhältnis"},
                                                          {"resolution", "Auflösung"},
                                                          {"exponential", "exponentiell"},
                                                          {"counts", "Zahl der Ereignisse"}};
    const auto known = words.find(english);
    return known == words.end() ? english : known->second;
}

TEST(StatementText, WordsOfAnotherLanguageAreReadBesideTheEnglishOnes) {
    const auto german = [](std::string_view text) {
        return read_statement(text, nm, true, in_german).value_or(TypedStatement{"refused"});
    };
    EXPECT_EQ(german("rechteckig 0,5"), (TypedStatement{"rectangular", 0.5}));
    EXPECT_EQ(german("Recht ± 0,5"), (TypedStatement{"rectangular", 0.5}));
    EXPECT_EQ(german("rechteck±0,5 µm"), (TypedStatement{"rectangular", 0.5, {}, {}, "um"}));
    EXPECT_EQ(german("rect 0,5"), (TypedStatement{"rectangular", 0.5}));
    EXPECT_EQ(german("0,5 nm rechteckig"), (TypedStatement{"rectangular", 0.5}));
    EXPECT_EQ(german(" Grenzen -1 bis 2"), (TypedStatement{"limits", -1.0, 2.0}));
    EXPECT_EQ(german("limits -1 to 2"), (TypedStatement{"limits", -1.0, 2.0}));
    EXPECT_EQ(german("-1 bis 2"), (TypedStatement{"limits", -1.0, 2.0}));
    EXPECT_EQ(german("trapezförmig ± 1, Verhältnis 0,5"), (TypedStatement{"trapezoidal", 1.0, 0.5}));
    EXPECT_EQ(german("Zahl der Ereignisse 12"), (TypedStatement{"counts", 12.0}));
    EXPECT_EQ(german("exp"), (TypedStatement{"exponential"}));
    EXPECT_EQ(german("75 nm"), (TypedStatement{"standard", 75.0}));
    EXPECT_EQ(german("U = 75 nm, k = 3"), (TypedStatement{"certificate-k", 75.0, 3.0}));
    EXPECT_EQ(german("quadratisch 3"), TypedStatement{"refused"});
    // A text that is written is read again.
    for (const TypedStatement& statement :
         {TypedStatement{"rectangular", 0.5}, TypedStatement{"limits", -1.0, 2.0},
          TypedStatement{"trapezoidal", 1.0, 0.5}, TypedStatement{"resolution", 0.1},
          TypedStatement{"counts", 12.0}, TypedStatement{"exponential"}})
        EXPECT_EQ(german(statement_text(statement, nm, plain, in_german)), statement);
    EXPECT_EQ(statement_text(TypedStatement{"limits", -1.0, 2.0}, nm, plain, in_german),
              "Grenzen -1 bis 2 nm");
}

TEST(StatementText, AListIsObservations) {
    const auto list = [](std::vector<double> values) {
        return TypedStatement{"observations", {}, {}, {}, {}, std::move(values)};
    };
    const Unit mm = Unit::of("mm");
    EXPECT_EQ(typed("10.1; 10.3; 10.2", mm), list({10.1, 10.3, 10.2}));
    EXPECT_EQ(typed("10.1, 10.3, -10.2 mm", mm), list({10.1, 10.3, -10.2}));
    EXPECT_EQ(typed("obs 10.1 10.3", mm), list({10.1, 10.3}));
    EXPECT_EQ(typed("10100 10300 10200 um", mm), list({10.1, 10.3, 10.2})) << "a unit at the end is of all";
    EXPECT_EQ(typed("20.1 degC; 20.2 degC; 295.15 K", Unit::of("degC")), list({20.1, 20.2, 22.0}));
    EXPECT_EQ(read_statement("10,1; 10,3; 10,2", mm, true).value(), list({10.1, 10.3, 10.2}));
    EXPECT_NE(objection("10.1; 10.3; 10.2 s", mm).find("no unit for"), std::string::npos);
    EXPECT_EQ(typed("75 k = 3"), (TypedStatement{"certificate-k", 75.0, 3.0})) << "two figures are none";
    EXPECT_EQ(statement_text(list({10.1, -10.3}), mm, plain), "observations 10.1; -10.3");
    EXPECT_EQ(typed(statement_text(list({10.1, -10.3, 5.0}), mm, plain), mm), list({10.1, -10.3, 5.0}));
}

TEST(StatementText, PartsOfTheValueStayParts) {
    EXPECT_EQ(typed("2 ppm", Unit::of("mm")), (TypedStatement{"standard", 2.0, {}, {}, "ppm"}));
    EXPECT_EQ(typed("rect 1 %", Unit::of("V")), (TypedStatement{"rectangular", 1.0, {}, {}, "%"}));
    EXPECT_EQ(typed("1 %", Unit()), (TypedStatement{"standard", 1.0, {}, {}, "%"}));
    EXPECT_NE(objection("limits 1 % to 2 %").find("no unit for"), std::string::npos);
}

TEST(StatementText, TheSecondFigureIsInTheUnitOfTheFirst) {
    EXPECT_EQ(typed("1 to 2 um"), (TypedStatement{"limits", 1.0, 2.0, {}, "um"}));
    EXPECT_EQ(typed("500 nm to 2 um"), (TypedStatement{"limits", 500.0, 2000.0}));
    EXPECT_EQ(typed("ctrap 3 um inexactness 200 nm"),
              (TypedStatement{"curvilinear-trapezoid", 3.0, 0.2, {}, "um"}));
    EXPECT_EQ(statement_text({"standard", 2.0, {}, {}, "ppm"}, nm, plain), "u = 2 ppm");
    EXPECT_EQ(statement_text({"limits", 1.0, 2.0, {}, "um"}, nm, plain), "limits 1 to 2 µm");
}

TEST(StatementText, AUnitMayBeginWithOne) {
    const Unit per_kelvin = Unit::of("1/K");
    EXPECT_EQ(typed("2e-6 1/K", per_kelvin), (TypedStatement{"standard", 2e-6}));
    EXPECT_EQ(typed("rect 2e-6 1/K", per_kelvin), (TypedStatement{"rectangular", 2e-6}));
    EXPECT_EQ(typed("U = 1e-6 1/°C, k = 2", per_kelvin),
              (TypedStatement{"certificate-k", 1e-6, 2.0, {}, "1/degC"}));
}

TEST(StatementText, TemperaturesHaveIntervalsAndLimits) {
    const Unit celsius = Unit::of("degC");
    EXPECT_EQ(typed("0.1 K", celsius), (TypedStatement{"standard", 0.1}));
    EXPECT_EQ(typed("±0.5 °C", celsius), (TypedStatement{"rectangular", 0.5}));
    EXPECT_EQ(typed("limits 293.15 K to 21 °C", celsius),
              (TypedStatement{"limits", 293.15, 294.15, {}, "K"}));
}

TEST(StatementText, DistributionsAreStatedByDeviationOrByTheirParameters) {
    const Unit number = Unit();
    EXPECT_EQ(typed("Laplace 0.3"), (TypedStatement{"laplace", 0.3}));
    EXPECT_EQ(typed("laplace scale 0.2 um"), (TypedStatement{"laplace-scale", 0.2, {}, {}, "um"}));
    EXPECT_EQ(typed("Weibull 0.3"), (TypedStatement{"weibull-deviation", 0.3}));
    EXPECT_EQ(typed("weibull scale 2, shape 1.5"), (TypedStatement{"weibull", 2.0, 1.5}));
    EXPECT_EQ(typed("weibull 2 um shape 1.5"), (TypedStatement{"weibull", 2.0, 1.5, {}, "um"}));
    EXPECT_EQ(typed("Poisson", number), (TypedStatement{"poisson"}));
    EXPECT_EQ(typed("Poisson 12", number), (TypedStatement{"poisson", 12.0}));
    EXPECT_EQ(typed("binomial n = 50, p = 2 %", number), (TypedStatement{"binomial", 50.0, 2.0}));
    EXPECT_EQ(typed("binomial n = 50, p = 0.02", number), (TypedStatement{"binomial", 50.0, 2.0}));
    EXPECT_EQ(typed("binomial 50", number), (TypedStatement{"binomial", 50.0}));
    EXPECT_NE(objection("binomial 50 2", number).find("p = 2 %"), std::string::npos);
    EXPECT_NE(objection("binomial n = 50, p = 2", number).find("p = 0.02"), std::string::npos);
    EXPECT_NE(objection("rect scale 2").find("scale"), std::string::npos);
    EXPECT_NE(objection("laplace scale").find("after 'scale'"), std::string::npos);
    EXPECT_NE(objection("weibull scale 2").find("shape"), std::string::npos);
}

TEST(StatementText, SamplesAndHistogramsAreLists) {
    TypedStatement sample{"sample"}, weighted{"sample"}, histogram{"histogram"};
    sample.observations = {10.1, 10.3, 10.2};
    weighted.observations = {1.0, 2000.0};
    weighted.weights = {2.0, 5.0};
    histogram.observations = {0.0, 1.0, 2.0};
    histogram.weights = {5.0, 8.0};
    EXPECT_EQ(typed("sample 10.1; 10.3; 10.2"), sample);
    EXPECT_EQ(typed("sample 1 2 um weights 2; 5").observations, (std::vector{1000.0, 2000.0}));
    EXPECT_EQ(typed("sample 1 nm; 2 um weights 2; 5"), weighted);
    EXPECT_EQ(typed("histogram 0; 1; 2 weights 5; 8"), histogram);
    EXPECT_EQ(typed("hist 0 1 2 weights 5 8"), histogram);
    for (const TypedStatement& statement : {sample, weighted, histogram, TypedStatement{"sample"}})
        EXPECT_EQ(typed(statement_text(statement, nm, plain)), statement);
    EXPECT_NE(objection("sample 1; 2 weights 1").find("as many weights"), std::string::npos);
    EXPECT_NE(objection("histogram 0; 1; 2").find("weights"), std::string::npos);
    EXPECT_NE(objection("histogram 0; 1; 2 weights 1; 2; 3").find("one edge more"), std::string::npos);
    EXPECT_NE(objection("1; 2; 3 weights 1; 2; 3").find("sample"), std::string::npos);
    EXPECT_NE(objection("rect 1 weights 2").find("weights"), std::string::npos);
}

TEST(StatementText, NothingIsGuessed) {
    EXPECT_NE(objection("U 75").find("k = "), std::string::npos);
    EXPECT_NE(objection("U 75 2").find("k = "), std::string::npos);
    EXPECT_NE(objection("rect").find("rectangular"), std::string::npos);
    EXPECT_NE(objection("rect 1 2").find("1 figure"), std::string::npos);
    EXPECT_NE(objection("about 3").find("about"), std::string::npos);
    EXPECT_NE(objection("3 kg").find("nm"), std::string::npos);
    EXPECT_NE(objection("rect 1 k 2").find("1 figure"), std::string::npos);
    EXPECT_NE(objection("tri 1 k").find("after 'k'"), std::string::npos);
    EXPECT_NE(objection("3 furlongs").find("furlongs"), std::string::npos);
    objection("1e999");
    objection("k 2");
}

// One form for each kind, which reads back to the same: what the cell shows can be edited.
TEST(StatementText, ReadsBackWhatIsWritten) {
    std::vector<TypedStatement> all{{"constant"}, {"observations"}, {"pooled", 4.0}, {"pooled"}};
    for (const StatementKind& kind : statement_kinds()) {
        TypedStatement statement{std::string(kind.key)};
        if (!kind.a.empty()) statement.a = kind.key == "counts" ? 12.0 : 0.125;
        if (!kind.b.empty()) statement.b = 2.5;
        if (kind.a_optional) all.push_back({std::string(kind.key)});
        all.push_back(statement);
        if (kind.b_optional) all.push_back({std::string(kind.key), statement.a});
    }
    for (const TypedStatement& statement : all)
        for (const char* unit : {"nm", "1", "arcsec", "degC", "%", "W/(m*K)"}) {
            const std::string text = statement_text(statement, Unit::of(unit), plain);
            EXPECT_EQ(typed(text, Unit::of(unit)), statement) << text;
            TypedStatement milli = statement;
            const StatementKind* kind = find_statement(statement.kind);
            if (!kind || !statement.a || !kind->a_has_unit || unit != std::string_view("nm")) continue;
            milli.unit = "mm";
            const std::string other = statement_text(milli, Unit::of(unit), plain);
            EXPECT_EQ(typed(other, Unit::of(unit)), milli) << other;
        }
    EXPECT_EQ(statement_text({"certificate-k", 75.0, 3.0}, nm, plain), "U = 75 nm, k = 3");
    EXPECT_EQ(statement_text({"rectangular", 0.5}, nm, plain), "rectangular ± 0.5 nm");
}

}  // namespace
}  // namespace covaria::statement_text_test
