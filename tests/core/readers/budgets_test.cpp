// Budgets of others: GUM Workbench and Suncal.
#include <cmath>

#include "core/kinds/models.h"
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
        EXPECT_NE(read.error().message.find(c.words), std::string::npos) << read.error().message;
    }
}

TEST(ReadGumWorkbench, TheBudgetGivesWhatTheFileStates) {
    const auto read = read_with("gum-workbench", data("mass.smu"), {.file_name = "mass.smu"});
    ASSERT_TRUE(read) << read.error().message;
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
    ASSERT_TRUE(read) << read.error().message;
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
