// Budgets in Excel workbooks: made of parts here, so that every refusal has its cell.
#include <cmath>

#include "core/kinds/registries.h"
#include "core/readers/budget_columns.h"
#include "tests/core/readers/reading.h"
#include "tests/core/readers/sheet.h"

namespace covaria::workbook_test {

using namespace readers_test;

namespace {

const std::vector<std::string> heads{"Quantity", "Value", "Unit", "U", "Divisor", "Distribution", "c"};

Result<Proposals> read_rows(std::vector<std::vector<std::string>> rows, ReadChoice choice = {}) {
    rows.insert(rows.begin(), heads);
    return read_with("xlsx", zipped(workbook(rows)), choice);
}

TEST(ReadWorkbook, TheContributionsDecideTheUnitsOfCoefficients) {
    const auto read = read_with("xlsx", data("budget.xlsx"), {.file_name = "budget.xlsx"});
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    const OutputResult l = first_order(*read).outputs.at(0);
    EXPECT_EQ(l.quantity.symbol, "l_X");
    EXPECT_NEAR(l.estimate, 0.049999926, 1e-16);
    // EA-4/02's sum of squares in nm, from the figures of the sheet.
    const double u_nm = std::sqrt(15.0 * 15.0 + 300.0 + 144.0 + 32.0 * 32.0 / 3.0 +
                                  575.0 * 575.0 * 0.05 * 0.05 / 3.0 + 100.0 / 3.0);
    EXPECT_NEAR(l.standard_uncertainty, u_nm * 1e-9, 1e-21);
    const std::string said = all_found(*read);
    for (const char* words : {"sheet 'Cover'", "12 what stands below the budget", "575 [nm/K]*delta_t"})
        EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    EXPECT_EQ((*reader_for(data("budget.xlsx"), "budget.xlsx"))->name, "xlsx");
}

TEST(ReadWorkbook, DivisorsAndDistributionsAgree) {
    const auto read = read_rows({{"a", v(1), "mm", v(0.3), "√3", "", v(2)},
                                 {"b", v(2), "mm", v(0.2), v(2), "", v(1)},
                                 {"c1", v(3), "mm", v(0.6), v(2 * std::sqrt(3.0)), "rectangular", v(1)},
                                 {"d", v(4), "mm", v(0.5), "", "triangular", v(-1)}});
    ASSERT_TRUE(read) << read.error().message.english();
    const OutputResult y = first_order(*read).outputs.at(0);
    EXPECT_NEAR(y.estimate, 3e-3, 1e-15) << "2 a + b + c1 - d";
    EXPECT_NEAR(y.standard_uncertainty, 1e-3 * std::sqrt(0.12 + 0.01 + 0.03 + 0.25 / 6.0), 1e-9);
    EXPECT_NE(all_found(*read).find("row 2: divisor √3 without a distribution"), std::string::npos)
        << all_found(*read);
}

TEST(ReadWorkbook, CellsThatSayNothingAreRefusedByTheirPlace) {
    const std::vector<std::string> good{"a", v(1), "mm", v(0.3), v(2), "", v(1)};
    struct Case {
        std::size_t column;
        const char *cell, *words;
    };
    for (const Case& c : {Case{1, "one", "B!B3: 'one' is no number"}, Case{2, "mmm", "B!C3: unit"},
                          Case{3, "<f>A1</f>", "B!D3: a formula that was never computed"},
                          Case{4, "", "B!D3: neither divisor, k nor distribution"},
                          Case{4, "root", "B!E3: 'root' is no divisor"},
                          Case{4, "<v>0</v>", "B!D3: the divisor must be greater than 0"},
                          Case{5, "cauchy", "B!D3: the distribution 'cauchy' is not known"},
                          Case{3, "<v>-1</v>", "B!D3: an uncertainty must not be negative"}}) {
        auto row = good;
        row[0] = "b";
        row[c.column] = c.cell;
        const auto read = read_rows({good, row});
        ASSERT_FALSE(read) << c.words;
        EXPECT_EQ(read.error().line, 3) << c.words;
        EXPECT_NE(read.error().message.english().find(c.words), std::string::npos)
            << read.error().message.english();
    }
}

TEST(ReadWorkbook, ColumnsMayBeStated) {
    const std::string bytes = zipped(workbook({{"Rig 4"}, {"probe", v(5), v(0.1), v(2)}}));
    const auto unknown = read_with("xlsx", bytes);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::usage);
    const auto read = read_with("xlsx", bytes, {.columns = {"name", "value [mm]", "U", "divisor"}});
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_NEAR(first_order(*read).outputs.at(0).standard_uncertainty, 5e-5, 1e-18);
    // The unit behind a header stays where the column is stated.
    const auto again = read_with("xlsx", data("budget.xlsx"),
                                 {.columns = {"quantity", "name", "value", "unit", "U", "divisor",
                                              "distribution", "nu", "c", "contribution", "-"},
                                  .sheet = "Budget"});
    ASSERT_TRUE(again) << again.error().message.english();
    EXPECT_EQ(first_order(*again).outputs.at(0).standard_uncertainty,
              first_order(*read_with("xlsx", data("budget.xlsx"))).outputs.at(0).standard_uncertainty);
    const auto table = find_reader("xlsx")->table(data("budget.xlsx"), {});
    ASSERT_TRUE(table);
    EXPECT_EQ(table->sheet, "Budget");
    EXPECT_EQ(table->columns.at(4), "U");
    EXPECT_EQ(table->rows.at(1).at(0), "l_S");
}

TEST(ReadWorkbook, BombsAreRefusedWithinBounds) {
    Parts bomb = workbook({});
    bomb["xl/worksheets/sheet1.xml"] = std::string(60'000'000, ' ');
    const std::string bytes = zipped(bomb);
    EXPECT_LT(bytes.size(), 100'000u);
    const auto refused = [&](const Parts& parts, const char* words) {
        const auto read = read_with("xlsx", zipped(parts));
        ASSERT_FALSE(read) << words;
        EXPECT_NE(read.error().message.english().find(words), std::string::npos)
            << read.error().message.english();
    };
    refused(bomb, "unpack to more than 16 MB");
    Parts entities = workbook({});
    entities["xl/worksheets/sheet1.xml"] =
        "<!DOCTYPE a [<!ENTITY b 'bbbb'><!ENTITY c '&b;&b;'>]><worksheet>&c;</worksheet>";
    refused(entities, "document type declaration");
    Parts outside = workbook({});
    outside["xl/_rels/workbook.xml.rels"] =
        "<Relationships><Relationship Id='r1' Type='http://x/worksheet' "
        "Target='../../../etc/passwd'/></Relationships>";
    refused(outside, "no part");
    refused({{"other.xml", "<a/>"}}, "no Excel workbook");
    std::string cut = data("budget.xlsx");
    cut.resize(cut.size() / 2);
    EXPECT_FALSE(read_with("xlsx", cut));
    EXPECT_NE(read_with("xlsx", "\xD0\xCF\x11\xE0 old").error().message.english().find("password"),
              std::string::npos);
}

TEST(ReadWorkbook, HeadersOfEa402AreKnown) {
    const std::vector<std::pair<const char*, BudgetColumn>> cases{
        {"Quantity X_i", BudgetColumn::quantity},
        {"Estimate x_i", BudgetColumn::value},
        {"Standard uncertainty u(x_i)", BudgetColumn::standard},
        {"Probability distribution", BudgetColumn::distribution},
        {"Sensitivity coefficient c_i", BudgetColumn::c},
        {"Uncertainty contribution u_i(y)", BudgetColumn::contribution},
        {"Value ±", BudgetColumn::limits},
        {"Value (±)", BudgetColumn::limits},
        {"vi or veff", BudgetColumn::nu},
        {"Sensitivitätskoeffizient", BudgetColumn::c},
        {"Half-width (a)", BudgetColumn::limits},
        {"Bewertung", BudgetColumn::unread},
        {"Relative standard uncertainty", BudgetColumn::unread},
        {"Divisor", BudgetColumn::divisor},
        {"Source of uncertainty", BudgetColumn::name},
        {"Freiheitsgrad", BudgetColumn::nu},
        {"Phase of the moon", BudgetColumn::unread}};
    for (const auto& [header, column] : cases) EXPECT_EQ(budget_head_of(header).column, column) << header;
    EXPECT_EQ(budget_head_of("Contribution [nm]").unit->text(), "nm");
    EXPECT_EQ(budget_head_of("Contribution / nm").unit->text(), "nm");
    EXPECT_EQ(budget_head_of("Contribution / (mV/V)").column, BudgetColumn::contribution);
    EXPECT_EQ(budget_head_of("Contribution / (mV/V)").unit->text(), "mV/V");
}

}  // namespace

}  // namespace covaria::workbook_test
