// Symbols alone and among words, as Unicode text and as HTML.
#include "core/text/symbol.h"

#include <gtest/gtest.h>

namespace covaria::symbol_test {
namespace {

TEST(Symbol, GreekLettersAndSubscriptsInUnicode) {
    EXPECT_EQ(symbol_to_unicode("alpha_7"), "α₇");
    EXPECT_EQ(symbol_to_unicode("b_1x"), "b₁ₓ");
    EXPECT_EQ(symbol_to_unicode("L_12"), "L₁₂");
    EXPECT_EQ(symbol_to_unicode("Delta"), "Δ");
    EXPECT_EQ(symbol_to_unicode("x"), "x");
    EXPECT_EQ(symbol_to_unicode("phi_beta"), "φᵦ");
    EXPECT_EQ(symbol_to_unicode("xbar"), "x\u0304");
    EXPECT_EQ(symbol_to_unicode("bar"), "bar");
    EXPECT_EQ(symbol_to_unicode("DeltaT_1"), "ΔT₁");
    EXPECT_EQ(parse_symbol("alpha_7_x^2"), (Symbol{"α", "7,x", "2"}));
}

TEST(Symbol, KeepsTheUnderscoreWhereUnicodeLacksASubscript) {
    EXPECT_EQ(symbol_to_unicode("u_c"), "u_c");
    EXPECT_EQ(symbol_to_unicode("p_AQ"), "p_AQ");
    EXPECT_EQ(symbol_to_unicode("u_alpha"), "u_α");
    EXPECT_EQ(symbol_to_unicode("u_b_1x"), "u_b,1x");
}

TEST(Symbol, Superscripts) {
    EXPECT_EQ(symbol_to_unicode("chi^2"), "χ²");
    EXPECT_EQ(symbol_to_unicode("s_p^2"), "sₚ²");
    EXPECT_EQ(symbol_to_unicode("x^q"), "x^q");
    EXPECT_EQ(to_html(symbol_text("s_p^2")), "<i>s</i><sub>p</sub><sup>2</sup>");
}

TEST(Symbol, Html) {
    EXPECT_EQ(to_html(symbol_text("alpha_7")), "<i>α</i><sub>7</sub>");
    EXPECT_EQ(to_html(symbol_text("nu_eff")), "<i>ν</i><sub>eff</sub>");
    EXPECT_EQ(to_html(symbol_text("u_b_1x")), "<i>u</i><sub>b,1x</sub>");
    EXPECT_EQ(to_html(symbol_text("a<b_\"&\"")), "<i>a&lt;b</i><sub>&quot;&amp;&quot;</sub>");
}

TEST(Symbol, SurvivesOddTexts) {
    EXPECT_EQ(symbol_to_unicode(""), "");
    EXPECT_EQ(symbol_to_unicode("_"), "_");
    EXPECT_EQ(symbol_to_unicode("_1"), "_1");
    EXPECT_EQ(symbol_to_unicode("x_"), "x");
    EXPECT_EQ(symbol_to_unicode("x_\xF0"), "x_\xF0");
    EXPECT_EQ(to_html(symbol_text("")), "");
}

TEST(Symbol, GreekLettersMayBeTyped) {
    EXPECT_EQ(plain_symbol("α_7"), "alpha_7");
    EXPECT_EQ(plain_symbol("θ₁"), "theta_1");
    EXPECT_EQ(plain_symbol("ΔT"), "DeltaT");
    EXPECT_EQ(plain_symbol("\u00B5_0"), "mu_0");
    EXPECT_EQ(plain_symbol("b₁ₓ"), "b_1x");
    EXPECT_EQ(plain_symbol("q_1,1"), "q_1,1");
    EXPECT_EQ(plain_symbol(""), "");
    EXPECT_EQ(symbol_to_unicode("theta1"), "θ1");
    EXPECT_EQ(symbol_to_unicode("x1"), "x1");
    for (const char* symbol : {"alpha_7", "theta_1", "b_1x", "x", "Omega_12", "phi_beta"})
        EXPECT_EQ(plain_symbol(symbol_to_unicode(symbol)), symbol);
}

TEST(SymbolsText, EveryWordIsASymbol) {
    EXPECT_EQ(to_unicode(symbols_text("b_1, b_2 … b_9 (9)")), "b₁, b₂ … b₉ (9)");
    EXPECT_EQ(to_html(symbols_text("U(x)")), "<i>U</i>(<i>x</i>)");
    EXPECT_EQ(to_html(symbols_text("q_1,1, q_2")), "<i>q</i><sub>1,1</sub>, <i>q</i><sub>2</sub>");
    EXPECT_EQ(to_html(symbols_text("u_x,u_y")), "<i>u</i><sub>x</sub>,<i>u</i><sub>y</sub>");
}

TEST(RunningText, SetsSubscriptedLettersOnly) {
    EXPECT_EQ(to_html(running_text("u_by in my_file & a")), "<i>u</i><sub>by</sub> in my_file &amp; a");
    EXPECT_EQ(to_html(running_text("α_7, ΔT_1 and ν_eff")),
              "<i>α</i><sub>7</sub>, <i>ΔT</i><sub>1</sub> and <i>ν</i><sub>eff</sub>");
    for (const char* words : {"mm", "2D_", "_x", "base_points", "file_1_a.csv", "u / mm", "−0.12", "für_x"})
        EXPECT_EQ(running_text(words), Text(words)) << words;
}

TEST(EquationText, SetsSingleLettersToo) {
    EXPECT_EQ(to_html(equation_text("y = atan2(r_32, alpha)")),
              "<i>y</i> = atan2(<i>r</i><sub>32</sub>, <i>α</i>)");
}

TEST(EquationText, SetsShortWordsAndBracesAsSymbols) {
    EXPECT_EQ(to_html(equation_text("|M − KS_j| + Rot_iᵀ d'_hij")),
              "|<i>M</i> − <i>KS</i><sub>j</sub>| + <i>Rot</i><sub>i</sub>ᵀ <i>d'</i><sub>hij</sub>");
    EXPECT_EQ(to_html(equation_text("z_{i−1} × z_i")), "<i>z</i><sub>i−1</sub> × <i>z</i><sub>i</sub>");
    EXPECT_EQ(to_html(equation_text("x_1-2")), "<i>x</i><sub>1</sub>-2") << "a minus sign";
}

TEST(SymbolsText, AHyphenBetweenFiguresIsOfTheSubscript) {
    EXPECT_EQ(to_html(symbols_text("L_1-2, L_2-3")), "<i>L</i><sub>1-2</sub>, <i>L</i><sub>2-3</sub>");
    EXPECT_EQ(to_html(running_text("Distribution of L_1-2.")), "Distribution of <i>L</i><sub>1-2</sub>.");
    EXPECT_EQ(to_html(running_text("z_i-1")), "<i>z</i><sub>i</sub>-1");
}

TEST(ScriptParts, WordsAndLabelsAreUpright) {
    const auto shown = [](const char* script) {
        std::string all;
        for (const ScriptPart& part : script_parts(script))
            all += part.italic ? "/" + part.letters + "/" : part.letters;
        return all;
    };
    EXPECT_EQ(shown("Rc"), "Rc");
    EXPECT_EQ(shown("m,Rc"), "/m/,Rc") << "of the mass, of the reference";
    EXPECT_EQ(shown("1x"), "1/x/");
    EXPECT_EQ(shown("ij"), "/ij/");
    EXPECT_EQ(shown("α"), "/α/");
    EXPECT_EQ(shown("cal"), "cal");
    EXPECT_EQ(shown("S"), "S") << "a label";
    EXPECT_EQ(shown("12"), "12");
    EXPECT_EQ(shown(""), "");
}

TEST(TitleText, IsASymbolWhereItLooksLikeOne) {
    for (const char* title : {"u_x", "alpha", "x"}) EXPECT_TRUE(looks_like_symbol(title)) << title;
    for (const char* title : {"point", "side length", ""}) EXPECT_FALSE(looks_like_symbol(title)) << title;
    EXPECT_EQ(to_html(title_text("Coordinate p_x")), "Coordinate <i>p</i><sub>x</sub>");
}

TEST(Text, PartsKeepTheirScripts) {
    const Text text = "u(" + symbol_text("b_1") + ") (mm)";
    EXPECT_EQ(text.letters(), "u(b1) (mm)");
    EXPECT_EQ(to_html(text.part(2, 5)), "<i>b</i><sub>1</sub>)");
    EXPECT_EQ(to_unicode(text.part(0, 5) + " now"), "u(b₁) now");
    EXPECT_EQ(text.part(6), Text("(mm)"));
    EXPECT_TRUE(text.has_scripts());
    EXPECT_FALSE(text.part(5).has_scripts());
    EXPECT_TRUE((Text() + Text("")).empty());
}

}  // namespace
}  // namespace covaria::symbol_test
