// The language of equations: what it reads, what it refuses and where.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "core/equation/evaluate.h"
#include "core/equation/typeset.h"

namespace covaria::equation::language_test {
namespace {

// Compiles `text` with quantities "a" to "h" of the given units and gives all that is wrong.
TextProblems problems_of(const std::string& text, const std::vector<KnownSymbol>& symbols = {}) {
    TextProblems problems;
    const ParsedText parsed = parse(text, problems);
    if (problems.empty()) compile(parsed, symbols, {}, problems);
    return problems;
}

double value_of(const std::string& text, const std::vector<std::pair<std::string, double>>& quantities = {}) {
    TextProblems problems;
    const ParsedText parsed = parse(text, problems);
    std::vector<KnownSymbol> symbols;
    for (const auto& [name, value] : quantities) symbols.push_back({name, Unit{}});
    const std::vector<WantedOutput> wanted{{"y", std::nullopt}};
    const Compiled compiled = compile(parsed, symbols, wanted, problems);
    EXPECT_TRUE(problems.empty()) << text << ": " << (problems.empty() ? "" : problems[0].message.english());
    if (!problems.empty()) return std::nan("");
    std::vector<double> registers(compiled.program.registers);
    put_constants(compiled.program, registers.data(), 1);
    for (const auto& input : compiled.program.inputs)
        registers[std::size_t(input.at)] = quantities[input.quantity].second;
    run(compiled.program, registers.data(), 1);
    return registers[std::size_t(compiled.program.outputs[0])];
}

TEST(Language, FollowsTheRulesOfArithmetic) {
    EXPECT_EQ(value_of("y = 1 + 2*3^2"), 19.0);
    EXPECT_EQ(value_of("y = 8/4/2"), 1.0);
    EXPECT_EQ(value_of("y = 8 - 4 - 2"), 2.0);
    EXPECT_EQ(value_of("y = -a^2", {{"a", 3}}), -9.0);
    EXPECT_EQ(value_of("y = 2^3^2"), 512.0);
    EXPECT_EQ(value_of("y = a^-2", {{"a", 2}}), 0.25);
    EXPECT_EQ(value_of("y = (1 + a)*2", {{"a", 2}}), 6.0);
    EXPECT_EQ(value_of("y = 2**3"), 8.0);
    EXPECT_EQ(value_of("y = 3·4 − 5"), 7.0);
    EXPECT_EQ(value_of("y = a² + √(16)", {{"a", 3}}), 13.0);
    EXPECT_EQ(value_of("y = 1.5e-3*.5e3"), 0.75);
}

TEST(Language, KnowsItsFunctions) {
    for (const auto& [text, expected] :
         std::vector<std::pair<std::string, double>>{{"sqrt(a)", std::sqrt(0.7)},
                                                     {"cbrt(a)", std::cbrt(0.7)},
                                                     {"exp(a)", std::exp(0.7)},
                                                     {"log(a)", std::log(0.7)},
                                                     {"ln(a)", std::log(0.7)},
                                                     {"log10(a)", std::log10(0.7)},
                                                     {"log2(a)", std::log2(0.7)},
                                                     {"sin(a)", std::sin(0.7)},
                                                     {"cos(a)", std::cos(0.7)},
                                                     {"tan(a)", std::tan(0.7)},
                                                     {"asin(a)", std::asin(0.7)},
                                                     {"acos(a)", std::acos(0.7)},
                                                     {"atan(a)", std::atan(0.7)},
                                                     {"sinh(a)", std::sinh(0.7)},
                                                     {"cosh(a)", std::cosh(0.7)},
                                                     {"tanh(a)", std::tanh(0.7)},
                                                     {"asinh(a)", std::asinh(0.7)},
                                                     {"acosh(1 + a)", std::acosh(1.7)},
                                                     {"atanh(a)", std::atanh(0.7)},
                                                     {"abs(-a)", 0.7},
                                                     {"sign(-a)", -1.0},
                                                     {"atan2(a, -2)", std::atan2(0.7, -2.0)},
                                                     {"hypot(a, 3, 4)", std::hypot(0.7, 3.0, 4.0)},
                                                     {"min(a, 0.2, 3)", 0.2},
                                                     {"max(a, 0.2, 3)", 3.0},
                                                     {"pow(a, 1.3)", std::pow(0.7, 1.3)},
                                                     {"cos(pi)", -1.0}})
        EXPECT_NEAR(value_of("y = " + text, {{"a", 0.7}}), expected,
                    1e-15 * std::max(1.0, std::abs(expected)))
            << text;
}

TEST(Language, ChoosesByCondition) {
    const std::string text = "y = if(a > 1 and not (a >= 3 or a == 2), 10, if(a != 2, 20, 30))";
    EXPECT_EQ(value_of(text, {{"a", 1.5}}), 10.0);
    EXPECT_EQ(value_of(text, {{"a", 2}}), 30.0);
    EXPECT_EQ(value_of(text, {{"a", 3}}), 20.0);
    EXPECT_EQ(value_of("y = if(a <= 0, 0, sqrt(a))", {{"a", -1}}), 0.0);
    // A branch not taken needs no value, even if none of it depends on a quantity.
    EXPECT_EQ(value_of("y = if(a > 0, a, 2*sqrt(-1))", {{"a", 3}}), 3.0);
    EXPECT_EQ(value_of("y = if(1 > 2, 1/0, a)", {{"a", 3}}), 3.0);
    EXPECT_EQ(value_of("y = if(2 > 1, a, log(0)) + if(a > 0, 1, if(a > 0, 1/0, 2))", {{"a", 3}}), 4.0);
}

TEST(Language, DefinitionsMayStandInAnyOrderAndGoOnInTheNextLine) {
    EXPECT_EQ(value_of("y = b + c  # the result\nb = 2*a; c = (b +\n 1)\n", {{"a", 3}}), 13.0);
    EXPECT_EQ(value_of("y = a +\n  1", {{"a", 3}}), 4.0);
}

TEST(Language, GreekLettersAreTheirNames) {
    EXPECT_EQ(value_of("y = α_s*π/π + μ", {{"alpha_s", 3}, {"mu", 1}}), 4.0);
}

TEST(Language, SolvesImplicitEquations) {
    EXPECT_NEAR(value_of("solve y = 1: y^2 = a", {{"a", 2}}), std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(value_of("solve y = 1: cos(y) = y"), 0.7390851332151607, 1e-15);
    // Colebrook for Re = 1e5 and a relative roughness of 1e-4 (fixed-point iteration to 16 digits).
    double f = 0.02;
    for (int i = 0; i < 100; ++i) f = std::pow(-2 * std::log10(1e-4 / 3.7 + 2.51 / (1e5 * std::sqrt(f))), -2);
    EXPECT_NEAR(value_of("solve y = 0.02: 1/sqrt(y) = -2*log10(k/3.7 + 2.51/(Re*sqrt(y)))",
                         {{"k", 1e-4}, {"Re", 1e5}}),
                f, 1e-16);
    EXPECT_NEAR(value_of("solve u = 3, v = 1: u + v = s and u*v = p\ny = u - v", {{"s", 5}, {"p", 6}}), 1.0,
                1e-14);
    // A step of Newton's method from 3 leaves the domain of the logarithm: it is halved.
    EXPECT_NEAR(value_of("solve y = 3: log(y) = 0"), 1.0, 1e-15);
}

struct Refusal {
    std::string text;
    std::size_t line, column;
    std::string words;
};

TEST(Language, RefusesWithThePlace) {
    const std::vector<Refusal> refusals{
        {"y = 2 3", 1, 7, "operator is missing"},
        {"y = (a + 2", 1, 5, "not closed"},
        {"y = a + 2)", 1, 10, "closes nothing"},
        {"y = a +", 1, 8, "expected here"},
        {"y = sin", 1, 5, "is a function"},
        {"y = foo(3)", 1, 5, "not a function"},
        {"sin = 3", 1, 1, "is a function"},
        {"pi = 3", 1, 1, "word of the language"},
        {"y = 1\ny = 2", 2, 1, "defined twice"},
        {"y = z + 1\nz = y", 2, 5, "defined by itself"},
        {"y = y + 1", 1, 5, "defined by itself"},
        {"a + 1", 1, 1, "starts with the name"},
        {"y = a = 3", 1, 7, "solve"},
        {"y = atan2(a)", 1, 5, "needs 2 arguments"},
        {"y = 3 [parsec]", 1, 7, "not known"},
        {"y = 3 [mm", 1, 7, "not closed"},
        {"y = 3 $ 4", 1, 7, "does not belong"},
        {"y = a\nx = nowhere*a", 2, 5, "neither defined nor"},
        {"y = a > 2", 1, 1, "would be a condition"},
        {"y = if(a, 1, 2)", 1, 5, "not a condition"},
        {"y = 1 + (a > 2)", 1, 7, "is a condition"},
        {"y = 1/0", 1, 6, "no value"},
        {"y = if(1/0 > a, 1, 2)", 1, 9, "no value"},
        {"solve y = 1: a = 3", 1, 16, "not depend on any unknown"},
        {"solve y = 1, z = 2: y + z = a", 1, 1, "2 unknowns"},
        {"solve y = 1 y = a", 1, 13, "colon"},
        {"y = 1e999", 1, 5, "too large"},
    };
    for (const Refusal& r : refusals) {
        const TextProblems problems = problems_of(r.text, {{"a", Unit{}}});
        ASSERT_FALSE(problems.empty()) << r.text;
        const bool found = std::any_of(problems.begin(), problems.end(), [&](const TextProblem& p) {
            return p.place.line == r.line && p.place.column == r.column &&
                   p.message.english().find(r.words) != std::string::npos;
        });
        EXPECT_TRUE(found) << r.text << " -> " << place_words(problems[0].place)
                           << problems[0].message.english();
    }
}

TEST(Language, ChecksDimensions) {
    const std::vector<KnownSymbol> known{
        {"l", Unit::of("mm")}, {"t", Unit::of("degC")}, {"phi", Unit::of("deg")},
        {"m", Unit::of("kg")}, {"n", Unit{}},           {"T", Unit::of("s")}};
    for (const char* good :
         {"y = l + 3 [um]", "y = t - 20 [degC]", "y = l*cos(phi)", "y = sqrt(l^2 + l*l)", "y = l^2/l + l",
          "y = phi + n", "y = l*phi + l", "y = max(l, 0)", "y = m/l^3", "y = l^(1/3)*l^(2/3) + l",
          "y = exp(l/(2 [mm]))", "y = atan2(l, 2*l) + phi", "y = if(l > 3 [mm], l, 0)",
          "y = 2*pi*sqrt(l/9.81 [m/s^2]) + T", "solve y = 1 [mm]: y^2 = l*y"}) {
        const TextProblems problems = problems_of(good, known);
        EXPECT_TRUE(problems.empty())
            << good << ": " << (problems.empty() ? "" : problems[0].message.english());
    }
    const std::vector<Refusal> refusals{
        {"y = l + t", 1, 7, "cannot be added"},
        {"y = l - 20 [degC]", 1, 7, "cannot be subtracted"},
        {"y = l + n", 1, 7, "'n' is a pure number"},
        {"y = sin(l)", 1, 5, "need an angle"},
        {"y = exp(l)", 1, 5, "pure number"},
        {"y = l^n", 1, 6, "must be a constant"},
        {"y = n^l", 1, 6, "exponent"},
        {"y = 1\nz = l*m\nx = z + l", 3, 7, "measured in m*kg"},
        {"y = if(l > t, 1, 2)", 1, 10, "cannot be compared"},
        {"y = if(l > 0, l, m)", 1, 5, "one kind"},
        {"y = atan2(l, m)", 1, 5, "one kind"},
        {"solve y = 1 [mm]: y^2 = l", 1, 23, "cannot be equal"},
    };
    for (const Refusal& r : refusals) {
        const TextProblems problems = problems_of(r.text, known);
        ASSERT_EQ(problems.size(), 1u) << r.text << (problems.empty() ? "" : problems[1].message.english());
        EXPECT_EQ(problems[0].place.line, r.line) << r.text;
        EXPECT_EQ(problems[0].place.column, r.column) << r.text;
        EXPECT_NE(problems[0].message.english().find(r.words), std::string::npos)
            << r.text << ": " << problems[0].message.english();
    }
}

// Each of these ends with a message and a place, soon.
TEST(Language, SurvivesHostileTexts) {
    const std::string many(10'000, '('), closing(10'000, ')');
    std::string chain = "y = 1", definitions = "y = a0\n", sum = "y = a";
    for (int i = 0; i < 20'000; ++i) chain += "+1";
    for (int i = 0; i < 2'500; ++i)
        definitions += "a" + std::to_string(i) + " = a" + std::to_string(i + 1) + "\n";
    for (int i = 0; i < 3'000; ++i) sum += "/sin(a*" + std::to_string(i) + ")";
    std::string bytes;
    for (int i = 1; i < 256; ++i) bytes += char(i);
    const auto start = std::chrono::steady_clock::now();
    for (const std::string& text : {"y = " + many + "a" + closing,
                                    "y = " + many,
                                    std::string(10'000, '-'),
                                    "y = " + std::string(10'000, '-') + "a",
                                    "y = a" + std::string(10'000, '^'),
                                    std::string(1'000'000, 'x'),
                                    std::string(1'000'000, '('),
                                    "y = a^" + std::string("a^") + many,
                                    bytes,
                                    std::string("y = \0 a", 7),
                                    std::string("\xff\xfe\xff"),
                                    std::string(";;;;"),
                                    std::string("y ="),
                                    std::string("="),
                                    std::string("solve"),
                                    std::string("solve y"),
                                    std::string("solve y = 1:"),
                                    std::string("solve y = 1: y ="),
                                    std::string("y = [["),
                                    std::string("y = 1 []"),
                                    "y = min(" + std::string(5'000, ',') + ")",
                                    "y = not not " + std::string(9'000, ' ') + "not",
                                    definitions + "a2500 = b",
                                    std::string("y = if(if(if(a, 1, 2), 3, 4), 5, 6)")}) {
        const TextProblems problems = problems_of(text, {{"a", Unit{}}});
        if (text == ";;;;") continue;  // nothing is said, and nothing is wrong with it
        ASSERT_FALSE(problems.empty()) << text.substr(0, 40);
        EXPECT_GE(problems[0].place.line, 1u);
        EXPECT_FALSE(problems[0].message.english().empty());
        EXPECT_LT(problems.size(), 50u);
    }
    for (const std::string& text : {chain, sum, definitions + "a2500 = a\n"}) {
        TextProblems problems;
        const ParsedText parsed = parse(text, problems);
        const std::vector<KnownSymbol> symbols{{"a", Unit{}}};
        compile(parsed, symbols, {}, problems);
        EXPECT_TRUE(problems.empty()) << text.substr(0, 40) << problems[0].message.english();
        for (const Formula& f : formulas(parsed)) EXPECT_FALSE(to_unicode(f).empty());
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    RecordProperty("seconds", std::to_string(taken.count()));
}

TEST(Typeset, WritesEquationsAsPeopleDo) {
    const auto shown = [](const std::string& text) {
        TextProblems problems;
        const std::vector<Formula> all = formulas(parse(text, problems));
        EXPECT_TRUE(problems.empty()) << text;
        return all.empty() ? std::string() : to_unicode(all.front());
    };
    EXPECT_EQ(shown("R = V/I*cos(phi)"), "R = V/I·cos(φ)");
    EXPECT_EQ(shown("y = a/(b*c)"), "y = a/(b·c)");
    EXPECT_EQ(shown("y = (a + b)/c"), "y = (a + b)/c");
    EXPECT_EQ(shown("y = a - (b - c)"), "y = a − (b − c)");
    EXPECT_EQ(shown("y = -(a + b)^2"), "y = −(a + b)²");
    EXPECT_EQ(shown("y = a^-1*sqrt(x_1)"), "y = a⁻¹·√(x₁)");
    EXPECT_EQ(shown("y = if(a > 0, abs(a), 20 [degC])"), "y = if(a > 0, |a|, 20\u00a0°C)");
    EXPECT_EQ(shown("solve f = 1: f^2 = x"), "f² = x solved for f");
    EXPECT_EQ(shown("y = (a^b)^c"), "y = (a^b)^c");
}

TEST(Typeset, WritesMathml) {
    TextProblems problems;
    const std::vector<Formula> all = formulas(parse("R_1 = V/I*sqrt(2)", problems));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(to_mathml(all[0]),
              "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" "
              "display=\"block\"><mrow><msub><mi>R</mi><mi>1</mi>"
              "</msub><mo>=</mo><mfrac><mi>V</mi><mi>I</mi></mfrac><mo>·</mo><msqrt><mn>2</mn></msqrt></"
              "mrow></math>");
}

TEST(Typeset, SubscriptsThatAreWordsAreUprightInMathml) {
    TextProblems problems;
    const std::vector<Formula> all = formulas(parse("y = m_Rc + delta_m_Rc + l_S", problems));
    ASSERT_EQ(all.size(), 1u);
    const std::string written = to_mathml(all[0]);
    EXPECT_NE(written.find("<msub><mi>m</mi><mi>Rc</mi></msub>"), std::string::npos) << written;
    EXPECT_NE(written.find("<mrow><mi>m</mi><mi>,Rc</mi></mrow>"), std::string::npos) << written;
    EXPECT_NE(written.find("<mi mathvariant=\"normal\">S</mi>"), std::string::npos) << written;
}

/// The first message about a text; "" if nothing is wrong. t, t_1, t_2 in degC, T in K, x a number.
std::string objection(const std::string& text, std::optional<Unit> wanted = std::nullopt) {
    TextProblems problems;
    const ParsedText parsed = parse(text, problems);
    std::vector<KnownSymbol> symbols{{"x", Unit{}}, {"T", Unit::of("K")}, {"R", Unit::of("J/K")}};
    for (const char* name : {"t", "t_1", "t_2"}) symbols.push_back({name, Unit::of("degC")});
    const std::vector<WantedOutput> outputs{{"y", wanted}};
    if (problems.empty()) compile(parsed, symbols, outputs, problems);
    return problems.empty() ? "" : problems[0].message.english();
}

TEST(Temperatures, DifferencesAreInKelvin) {
    for (const char* text : {"y = t_1 - t_2", "y = t - 20 [degC]", "y = 2*(t_1 - t_2) + 3 [K]",
                             "y = abs(t_1 - t_2)", "y = (t_1 + t_2)/2 - t", "d = t_1 - t_2\ny = d/2"}) {
        EXPECT_EQ(objection(text), "") << text;
        EXPECT_NE(objection(text, Unit::of("degC")).find("difference of temperatures"), std::string::npos)
            << text;
    }
}

TEST(Temperatures, MeansAndShiftedTemperaturesStayOnTheScale) {
    for (const char* text :
         {"y = t", "y = t + 3 [K]", "y = 3 [K] + t", "y = t - T", "y = (t_1 + t_2)/2",
          "y = 0.25*t_1 + 0.75*t_2", "y = max(t_1, t_2)", "y = if(t > 20 [degC], t_1, t_2)",
          "y = t_1 + (t_2 - t)*x", "y = t + 0", "y = t_1 - t_2 + t", "y = -(-t)"}) {
        EXPECT_EQ(objection(text), "") << text;
        EXPECT_EQ(objection(text, Unit::of("degC")), "") << text;
    }
}

TEST(Temperatures, OnlyTheRatioOfTwoIsTakenInKelvin) {
    for (const char* text :
         {"y = t_1/t_2", "y = sqrt(t/t_1)", "y = R*t_1/t_2", "y = x*t_2*T/(t_1*R)", "y = (t_1/t_2)^1.5",
          "a = R*t_1\nb = R*t_2\ny = a/b", "y = t^2/t_1^2", "y = t/20 [degC]", "y = exp(-t_1/t_2)",
          "y = R*(t_1 - t_2)", "y = (t - 0 [degC])*x", "y = x*(1 + x*((t - 0 [degC])/1 [K])^2)",
          "y = abs(t_1 - t_2)/T", "y = ((t_1 + t_2)/2)/t"})
        EXPECT_EQ(objection(text), "") << text;
    for (const char* text : {"y = R*t",
                             "y = t*R",
                             "y = t/T",
                             "y = T/t",
                             "y = exp(-t/T)",
                             "y = 1.5*t*R",
                             "y = x*(1 + t/T)",
                             "y = t*(1 + x)",
                             "y = (1 - x)*t_1 + x*t_2",
                             "y = t^2",
                             "y = sqrt(t)",
                             "y = t^4 - t_1^4",
                             "y = x*t",
                             "y = R*t > 3 [J]",
                             "y = if(R*t > 3 [J], 1, 2)",
                             "y = sin(t/T)",
                             "y = x^(t/T)",
                             "y = abs(t)",
                             "y = sign(t)",
                             "y = hypot(t_1, t_2)",
                             "a = R*t\ny = a/R",
                             "y = 20 [degC]*x",
                             "y = max(R*t, R*T)",
                             "y = log(t/(1 [K]))",
                             "solve y = 1: x = y*(1 + t/T)",
                             "y = R*(t + 3 [K])",
                             "y = (t_1 - t_2)*t"})
        EXPECT_NE(objection(text).find("would be taken in kelvin"), std::string::npos)
            << text << ": " << objection(text);
    for (const char* text : {"y = 1.001*t", "y = -t", "y = 2*t > 30 [degC]", "y = max(2*t, t_1)", "y = t/2"})
        EXPECT_NE(objection(text).find("a multiple of a temperature in degC"), std::string::npos)
            << text << ": " << objection(text);
    for (const std::optional<Unit>& wanted : {std::optional<Unit>(), std::optional(Unit::of("degC")),
                                              std::optional(Unit::of("K")), std::optional(Unit::of("mK"))}) {
        EXPECT_NE(objection("y = t*(1 + x)", wanted), "");
        EXPECT_NE(objection("y = t*1.001", wanted), "") << "as with a gain that is not known exactly";
    }
}

TEST(Temperatures, AWayOutNamesEveryPlaceOfTheTemperature) {
    TextProblems problems;
    const ParsedText parsed = parse("a = 2*x\ny = x*(1 + x*t/1 [K] + x*(t/1 [K])^2)", problems);
    const std::vector<KnownSymbol> symbols{{"x", Unit{}}, {"t", Unit::of("degC")}};
    compile(parsed, symbols, std::vector<WantedOutput>{{"y", std::nullopt}}, problems);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].reading, "t");
    ASSERT_EQ(problems[0].readings.size(), 2u);
    EXPECT_EQ(problems[0].place.column, 14u);
    EXPECT_EQ(problems[0].readings[1].line, 2u);
    EXPECT_EQ(problems[0].readings[1].column, 27u);
}

/// Whether the output y is an angle on the circle. phi, psi in deg, x a number, n in rev.
bool is_on_circle(const std::string& text, const char* unit = "deg") {
    TextProblems problems;
    const ParsedText parsed = parse(text, problems);
    const std::vector<KnownSymbol> symbols{
        {"phi", Unit::of("deg")}, {"psi", Unit::of("mrad")}, {"x", Unit{}}, {"n", Unit::of("rev")}};
    const Compiled made =
        compile(parsed, symbols, std::vector<WantedOutput>{{"y", Unit::of(unit)}}, problems);
    EXPECT_TRUE(problems.empty()) << text;
    return !made.outputs.empty() && made.outputs.front().on_circle;
}

TEST(Angles, AreOnTheCircleWhereTurnsMakeNoDifference) {
    for (const char* text :
         {"y = atan2(x, 2)", "y = asin(x)", "y = acos(x)", "y = atan(x)", "y = phi", "y = phi - psi",
          "y = atan2(x, 1) + pi", "y = 2*phi", "y = -phi", "y = if(x > 0, phi, phi + 180 [deg])",
          "a = phi - psi\ny = a + 360 [deg]", "solve y = 10 [deg]: y - 0.1*sin(y) = phi"}) {
        EXPECT_TRUE(is_on_circle(text)) << text;
        EXPECT_FALSE(is_on_circle(text, "rev")) << text << ": counts of turns";
        EXPECT_FALSE(is_on_circle(text, "1")) << text << ": a number";
    }
    for (const char* text : {"y = x*phi", "y = phi/2", "y = 0.5*atan2(x, 1)", "y = abs(phi)", "y = n",
                             "y = x", "y = phi + x", "y = phi^2/1 [rad]", "y = sin(phi)"})
        EXPECT_FALSE(is_on_circle(text)) << text;
}

TEST(Temperatures, SumsThatMeanNothingAreRefused) {
    for (const char* text :
         {"y = t_1 + t_2", "y = t + 20 [degC]", "y = R*(t_1 + t_2)", "y = t_1 + t_2 + t", "y = (t_1 + t_2)/T",
          "y = ((t_1 + t_2)/T)^2", "y = (t_1 + t_2)^2", "y = sqrt((t_1 + t_2)/T)", "s = t_1 + t_2\ny = s*x"})
        EXPECT_NE(objection(text).find("sum of temperatures in degC"), std::string::npos)
            << text << ": " << objection(text);
    for (const char* text : {"y = if(t_1 - t_2 > 1 [degC], x, 0)", "y = max(t_1 - t_2, 1 [degC])",
                             "y = if(x > 0, t, t_1 - t_2)"})
        EXPECT_NE(objection(text).find("a difference of temperatures: give differences in K"),
                  std::string::npos)
            << text << ": " << objection(text);
    EXPECT_NE(objection("y = if(t > 0, x, 0)").find("write 0 [degC]"), std::string::npos);
    EXPECT_EQ(objection("y = if(t > 0 [degC], x, 0)"), "");
    EXPECT_EQ(objection("y = if(t_1 - t_2 > 0, x, 0)"), "");
    EXPECT_NE(objection("solve y = 20 [degC]: y = t_1 - t_2").find("difference"), std::string::npos);
    EXPECT_EQ(objection("solve y = 20 [degC]: y - t_1 = t_2 - y"), "");
}

}  // namespace
}  // namespace covaria::equation::language_test
