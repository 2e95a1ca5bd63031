// Symbols as Unicode text and as HTML.
#include "core/base/symbol.h"

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
    EXPECT_EQ(symbol_to_html("s_p^2"), "<i>s</i><sub>p</sub><sup>2</sup>");
}

TEST(Symbol, Html) {
    EXPECT_EQ(symbol_to_html("alpha_7"), "<i>α</i><sub>7</sub>");
    EXPECT_EQ(symbol_to_html("nu_eff"), "<i>ν</i><sub>eff</sub>");
    EXPECT_EQ(symbol_to_html("u_b_1x"), "<i>u</i><sub>b,1x</sub>");
    EXPECT_EQ(symbol_to_html("a<b_\"&\""), "<i>a&lt;b</i><sub>&quot;&amp;&quot;</sub>");
}

TEST(Symbol, SurvivesOddTexts) {
    EXPECT_EQ(symbol_to_unicode(""), "");
    EXPECT_EQ(symbol_to_unicode("_"), "_");
    EXPECT_EQ(symbol_to_unicode("_1"), "_1");
    EXPECT_EQ(symbol_to_unicode("x_"), "x");
    EXPECT_EQ(symbol_to_unicode("x_\xF0"), "x_\xF0");
    EXPECT_EQ(symbol_to_html(""), "<i></i>");
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

}  // namespace
}  // namespace covaria::symbol_test
