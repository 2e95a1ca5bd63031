// Compiled equations over the three number types.
#include <gtest/gtest.h>

#include <cmath>

#include <complex>

#include "core/equation/complex_numbers.h"
#include "core/equation/evaluate.h"

namespace covaria::equation::evaluation_test {
namespace {

Program compiled(const std::string& text, const std::vector<std::string>& names) {
    TextProblems problems;
    const ParsedText parsed = in_real_numbers(parse(text, problems), problems);
    std::vector<KnownSymbol> symbols;
    for (const std::string& name : names) symbols.push_back({name, Unit{}});
    const std::vector<WantedOutput> wanted{{"y", std::nullopt}};
    Compiled result = compile(parsed, symbols, wanted, problems);
    for (const TextProblem& p : problems)
        ADD_FAILURE() << text << ": " << place_words(p.place) << p.message.english();
    return result.program;
}

template <class Real>
Real value(const Program& program, const std::vector<Real>& x) {
    std::vector<Real> registers(program.registers);
    put_constants(program, registers.data(), 1);
    for (const auto& input : program.inputs) registers[std::size_t(input.at)] = x[input.quantity];
    run(program, registers.data(), 1);
    return registers[std::size_t(program.outputs[0])];
}

const std::vector<std::string> expressions{
    "y = sqrt(a)*cbrt(b) + exp(-a)*log(b) + log10(a + b)*log2(b)",
    "y = sin(a)*cos(b) + tan(a*b/4) + asin(a/3) + acos(b/4) + atan(a - b)",
    "y = sinh(a) + cosh(b) + tanh(a*b) + asinh(a) + acosh(1 + b) + atanh(a/3)",
    "y = a^3 - b^-2 + a^b + pow(a, 1.7) + abs(a - b) + hypot(a, b)",
    "y = atan2(a - 2*b, b - a) + min(a, b)*max(a, 0.5) + if(a < b, a*a, b) + sign(b)*a",
    "solve y = 1: y^3 + a*y = b",
    "solve p = 0.4, q = 3: p*q = a + exp(b/9) and p^2 + q = a*b + 3\ny = p/q",
    "z = complex(a, b)*polar(b, a) + sqrt(complex(a, -b))/complex(b, a)\ny = re(z) + im(conj(z))*abs(z) + "
    "arg(z)",
    "w = exp(z)*log(z)^2 + sin(z)*cosh(z) - z^1.7 + complex(b, 1)^z\nz = complex(a, b)\ny = re(w)*im(w)",
    "solve z = complex(1, 1): z*z + a*z = complex(b, a)\ny = abs(z)",
    "solve p = a, q = b, r = 1: p + 0.1*q^2 = a and sin(p*r)/9 + q = b and r*exp(q/9) = 2\ny = p + q*r^2"};

TEST(Evaluation, VectorsOfTrialsEqualSingleTrials) {
    for (const std::string& text : expressions) {
        const Program program = compiled(text, {"a", "b"});
        double a[] = {0.4, 1.1, 1.3, 0.9}, b[] = {1.2, 0.7, 1.9, 2.3};
        const Batch y = value<Batch>(program, {Batch::load_unaligned(a), Batch::load_unaligned(b)});
        for (std::size_t lane = 0; lane < 4; ++lane) {
            const double single = value<double>(program, {a[lane], b[lane]});
            EXPECT_TRUE(std::isfinite(single)) << text << " at " << a[lane] << ", " << b[lane];
            EXPECT_NEAR(y.get(lane), single, 1e-13 * std::max(1.0, std::abs(single))) << text;
        }
    }
}

TEST(Evaluation, DerivativesEqualDifferences) {
    for (const std::string& text : expressions) {
        const Program program = compiled(text, {"a", "b"});
        const double a = 1.1, b = 1.7, h = 1e-5;
        const Dual y = value<Dual>(program, {Dual::variable(a, 0), Dual::variable(b, 1)});
        const auto f = [&](double da, double db) { return value<double>(program, {a + da, b + db}); };
        const auto difference = [&](double da, double db) {
            return (8 * (f(da, db) - f(-da, -db)) - (f(2 * da, 2 * db) - f(-2 * da, -2 * db))) / (12 * h);
        };
        EXPECT_NEAR(y.value(), f(0, 0), 1e-13 * std::max(1.0, std::abs(y.value()))) << text;
        EXPECT_NEAR(y.partials()[0], difference(h, 0), 1e-8 * std::max(1.0, std::abs(y.partials()[0])))
            << text;
        EXPECT_NEAR(y.partials()[1], difference(0, h), 1e-8 * std::max(1.0, std::abs(y.partials()[1])))
            << text;
    }
}

/// Every function of complex numbers against the library's, in all four quadrants.
TEST(Evaluation, ComplexNumbersAreThoseOfTheLibrary) {
    using C = std::complex<double>;
    using Function = C (*)(const C&, const C&);
    const std::vector<std::pair<const char*, Function>> cases{
        {"z + w", [](const C& z, const C& w) { return z + w; }},
        {"2*z - w/3", [](const C& z, const C& w) { return 2.0 * z - w / 3.0; }},
        {"z*w", [](const C& z, const C& w) { return z * w; }},
        {"z/w", [](const C& z, const C& w) { return z / w; }},
        {"1/z", [](const C& z, const C&) { return 1.0 / z; }},
        {"-conj(z)", [](const C& z, const C&) { return -std::conj(z); }},
        {"z^3", [](const C& z, const C&) { return z * z * z; }},
        {"z^-2", [](const C& z, const C&) { return 1.0 / (z * z); }},
        {"z^0.3", [](const C& z, const C&) { return std::pow(z, 0.3); }},
        {"z^w", [](const C& z, const C& w) { return std::pow(z, w); }},
        {"2^z", [](const C& z, const C&) { return std::pow(C(2.0), z); }},
        {"sqrt(z)", [](const C& z, const C&) { return std::sqrt(z); }},
        {"exp(z)", [](const C& z, const C&) { return std::exp(z); }},
        {"log(z)", [](const C& z, const C&) { return std::log(z); }},
        {"sin(z)", [](const C& z, const C&) { return std::sin(z); }},
        {"cos(z)", [](const C& z, const C&) { return std::cos(z); }},
        {"tan(z)", [](const C& z, const C&) { return std::tan(z); }},
        {"sinh(z)", [](const C& z, const C&) { return std::sinh(z); }},
        {"cosh(z)", [](const C& z, const C&) { return std::cosh(z); }},
        {"tanh(z)", [](const C& z, const C&) { return std::tanh(z); }},
        {"complex(abs(z), arg(z))", [](const C& z, const C&) { return C(std::abs(z), std::arg(z)); }},
        {"polar(abs(z), arg(w))",
         [](const C& z, const C& w) { return std::polar(std::abs(z), std::arg(w)); }},
        {"if(re(z) > 0, z, 1)", [](const C& z, const C&) { return z.real() > 0 ? z : C(1.0); }}};
    for (const auto& [text, function] : cases)
        for (const double a : {-1.3, 0.4})
            for (const double b : {-0.7, 1.9}) {
                const C z(a, b), w(b, 0.6);
                const std::string head =
                    std::string("v = ") + text + "\nz = complex(a, b)\nw = complex(b, 0.6)\n";
                const C expected = function(z, w);
                const double size = std::max(1.0, std::abs(expected));
                EXPECT_NEAR(value<double>(compiled(head + "y = re(v)", {"a", "b"}), {a, b}), expected.real(),
                            1e-14 * size)
                    << text;
                EXPECT_NEAR(value<double>(compiled(head + "y = im(v)", {"a", "b"}), {a, b}), expected.imag(),
                            1e-14 * size)
                    << text;
            }
}

TEST(Evaluation, TextsWithoutComplexNumbersStayAsTheyAre) {
    TextProblems problems;
    const ParsedText parsed = parse("y = re*im + arg^2", problems);
    EXPECT_EQ(in_real_numbers(parsed, problems).nodes.size(), parsed.nodes.size());
    EXPECT_TRUE(complex_definitions(parsed).empty());
    EXPECT_TRUE(problems.empty()) << "re, im and arg may be names";
}

TEST(Evaluation, ComplexMistakesAreSaidWhereTheyAre) {
    const auto objection = [](const std::string& text) {
        TextProblems problems;
        in_real_numbers(parse(text, problems), problems);
        return problems.empty() ? std::string() : problems.front().message.english();
    };
    EXPECT_NE(objection("y = if(complex(a, b) > 1, 1, 2)").find("no order"), std::string::npos);
    EXPECT_NE(objection("y = asin(complex(a, b))").find("sqrt"), std::string::npos);
    EXPECT_NE(objection("y = complex(complex(a, b), 1)").find("are real"), std::string::npos);
    EXPECT_NE(objection("Z = complex(a, b)\ny = Z_re*2").find("re(Z)"), std::string::npos);
    EXPECT_NE(objection("solve z = complex(1, 1): abs(z) = a").find("2 real unknowns and 1"),
              std::string::npos);
    EXPECT_EQ(objection("Z = complex(a, b)\nx = abs(Z)"), "");
}

TEST(Evaluation, ImplicitDerivativesAreExact) {
    const Program program = compiled("solve y = 1: y^2 = a", {"a"});
    const Dual y = value<Dual>(program, {Dual::variable(2.0, 0)});
    EXPECT_NEAR(y.partials()[0], 0.5 / std::sqrt(2.0), 1e-15);
}

/// u_k + (u_(k-1) + u_(k+1))/4 + u_k^3/9 = a + k b/40 for k = 1 ... n, u_0 = u_(n+1) = 0; y is the last.
std::string chain_of(std::size_t n) {
    const auto u = [&](std::size_t k) {
        return k == 0 || k > n ? std::string("0") : k == n ? "y" : "u" + std::to_string(k);
    };
    std::string unknowns, equations;
    for (std::size_t k = 1; k <= n; ++k) {
        unknowns += (k > 1 ? ", " : "") + u(k) + " = 1";
        equations += (k > 1 ? " and " : " ") + u(k) + " + (" + u(k - 1) + " + " + u(k + 1) + ")/4 + " + u(k) +
                     "^3/9 = a + " + std::to_string(k) + "*b/40";
    }
    return "solve " + unknowns + ":" + equations;
}

TEST(Evaluation, SystemsOfAllSizesAreSolved) {
    for (std::size_t n = 1; n <= most_unknowns; ++n) {
        const Program program = compiled(chain_of(n), {"a", "b"});
        ASSERT_EQ(program.systems.front().size(), n);
        const double a = 1.3, b = 0.7, h = 1e-5;
        const auto f = [&](double da, double db) { return value<double>(program, {a + da, b + db}); };
        const Dual y = value<Dual>(program, {Dual::variable(a, 0), Dual::variable(b, 1)});
        EXPECT_NEAR(y.partials()[0], (f(h, 0) - f(-h, 0)) / (2 * h), 1e-9) << n;
        EXPECT_NEAR(y.partials()[1], (f(0, h) - f(0, -h)) / (2 * h), 1e-9) << n;
        std::vector<double> u(n + 2, 0.0);  // by Gauss and Seidel: each from its neighbours, until they stay
        for (int sweep = 0; sweep < 200; ++sweep)
            for (std::size_t k = 1; k <= n; ++k) {
                const double right = a + static_cast<double>(k) * b / 40 - (u[k - 1] + u[k + 1]) / 4;
                for (int step = 0; step < 3; ++step)
                    u[k] -= (u[k] + u[k] * u[k] * u[k] / 9 - right) / (1 + u[k] * u[k] / 3);
            }
        EXPECT_NEAR(f(0, 0), u[n], 1e-12) << n;
        const Batch lanes = value<Batch>(program, {Batch(a), Batch(b)});
        EXPECT_NEAR(lanes.get(0), u[n], 1e-12) << n;
    }
}

TEST(Evaluation, TooLargeASystemIsRefusedWithItsLimit) {
    TextProblems problems;
    parse(chain_of(most_unknowns + 1), problems);
    ASSERT_FALSE(problems.empty());
    EXPECT_NE(problems[0].message.english().find("41 unknowns"), std::string::npos)
        << problems[0].message.english();
    EXPECT_NE(problems[0].message.english().find("the limit is 40"), std::string::npos);
}

// One lane without a solution neither stops nor changes the others.
TEST(Evaluation, LanesDoNotInfluenceEachOther) {
    const Program program = compiled("solve y = 1: y^2 = a", {"a"});
    double a[] = {4.0, -1.0, 2.0, 1e-300};
    const Batch y = value<Batch>(program, {Batch::load_unaligned(a)});
    EXPECT_EQ(y.get(0), value<double>(program, {4.0}));
    EXPECT_TRUE(std::isnan(y.get(1)));
    EXPECT_EQ(y.get(2), value<double>(program, {2.0}));
    EXPECT_TRUE(std::isnan(value<double>(program, {-1.0})));
}

TEST(Evaluation, WhatOccursTwiceIsComputedOnce) {
    const Program program = compiled("y = sin(a)*sin(a) + sin(a)", {"a"});
    EXPECT_EQ(program.instructions.size(), 3u);
    const Program constants = compiled("y = a*(2*3 + sqrt(16))", {"a"});
    EXPECT_EQ(constants.instructions.size(), 1u);
}

}  // namespace
}  // namespace covaria::equation::evaluation_test
