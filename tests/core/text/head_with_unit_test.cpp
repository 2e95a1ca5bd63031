#include "core/text/head_with_unit.h"

#include <gtest/gtest.h>

#include "core/text/symbol.h"

namespace covaria::head_with_unit_test {
namespace {

std::string head(const Text& name, const char* unit) {
    return to_unicode(head_with_unit(name, Unit::of(unit)));
}

std::string axis(const Text& name, const char* unit, int exponent) {
    return to_unicode(head_with_unit(name, std::string(unit), exponent));
}

TEST(HeadWithUnit, IsTheQuotientOfNameAndUnit) {
    EXPECT_EQ(head("U (k = 2)", "um"), "U (k = 2) / µm");
    EXPECT_EQ(head("number", "1"), "number");
    EXPECT_EQ(head("part", "%"), "part / %");
    EXPECT_EQ(head("area", "mm^2"), "area / mm²");
    EXPECT_EQ(head_with_unit("u(" + symbol_text("b_1") + ")", Unit::of("mm")),
              "u(" + symbol_text("b_1") + ") / mm");
}

TEST(HeadWithUnit, HasCompoundUnitsAndSumsInParentheses) {
    EXPECT_EQ(head("c", "nm/K"), "c / (nm/K)");
    EXPECT_EQ(head("M", "N*m"), "M / (N·m)");
    EXPECT_EQ(head("alpha", "1/K"), "alpha / (1/K)");
    EXPECT_EQ(head("value − U", "mm"), "(value − U) / mm");
    EXPECT_EQ(head("u(a + b)", "mm"), "u(a + b) / mm");
    EXPECT_EQ(head("u in A-B", "mm"), "u in A-B / mm") << "a hyphen is no sign";
}

TEST(HeadWithUnit, TellsThePowerOfTen) {
    EXPECT_EQ(axis("x", "mm", 0), "x / mm");
    EXPECT_EQ(axis("x", "mm", -6), "x / (10⁻⁶ mm)");
    EXPECT_EQ(axis("probability density", "1/mm", 6), "probability density / (10⁶/mm)");
    EXPECT_EQ(axis("x", "", 12), "x / 10¹²");
    EXPECT_EQ(axis("x", "", 0), "x");
    EXPECT_EQ(axis({}, "mm", 0), "mm") << "where only the unit has room";
}

}  // namespace
}  // namespace covaria::head_with_unit_test
