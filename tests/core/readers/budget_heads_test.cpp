// Budgets in sheets of every language and order: each column is read as what its head says, or asked about.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <random>

#include "core/made/import_reading.h"
#include "core/readers/budget_words.h"
#include "tests/core/readers/reading.h"
#include "tests/core/readers/sheet.h"

namespace covaria::budget_heads_test {

using namespace readers_test;

namespace {

using Rows = std::vector<std::vector<std::string>>;

Result<Proposals> read_rows(const Rows& rows, ReadChoice choice = {}) {
    if (choice.file_name.empty()) choice.file_name = "budget.xlsx";
    return read_proposals(*find_reader("xlsx"), zipped(workbook(rows)), choice);
}

const char* const languages[] = {"en", "de", "fr", "es", "it", "pt"};

const char* key_of(BudgetColumn column) {
    for (const BudgetColumnWord& word : budget_column_words())
        if (word.column == column) return word.key;
    return "-";
}

TEST(BudgetHeads, EveryKnownWordIsItsColumnInCapitalsAndWithItsSymbol) {
    for (const BudgetWord& word : budget_words()) {
        std::string capitals = word.words;
        for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        for (const std::string& head : {std::string(word.words), capitals, "  " + capitals + " "}) {
            const BudgetHead read = budget_head_of(head);
            EXPECT_TRUE(read.understood) << head;
            EXPECT_EQ(key_of(read.column), std::string(key_of(word.column))) << head;
        }
        for (const BudgetSymbol& symbol : budget_symbols())
            if (symbol.column == word.column && word.column != BudgetColumn::unread) {
                EXPECT_EQ(budget_head_of(std::string(word.words) + " " + symbol.symbol).column, word.column)
                    << word.words << " " << symbol.symbol;
            }
        EXPECT_FALSE(budget_head_of("xyzzy " + std::string(word.words)).understood) << word.words;
        EXPECT_FALSE(budget_head_of(std::string(word.words) + "xyzzy").understood) << word.words;
    }
}

TEST(BudgetHeads, ACoverageFactorBehindTheHeadCounts) {
    for (const char* head :
         {"U (k=2)", "Expanded uncertainty (k = 2)", "U, k = 2,00", "Erweiterte Messunsicherheit U (k=2)"}) {
        const BudgetHead read = budget_head_of(head);
        EXPECT_EQ(read.column, BudgetColumn::expanded) << head;
        EXPECT_EQ(read.k, 2.0) << head;
    }
    const auto read = read_rows({{"Name", "Value", "Unit", "U (k=2)"}, {"a", v(1), "mm", v(0.3)}});
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_NEAR(first_order(*read).outputs.at(0).standard_uncertainty, 1.5e-4, 1e-18);
}

/// A budget whose right u is sqrt((2 x 15)^2 + (3 x 20)^2 + 12^2) nm, with columns in any order.
struct GeneratedSheet {
    std::vector<BudgetColumn> columns{
        BudgetColumn::quantity, BudgetColumn::name,         BudgetColumn::value,
        BudgetColumn::unit,     BudgetColumn::standard,     BudgetColumn::nu,
        BudgetColumn::c,        BudgetColumn::contribution, BudgetColumn::distribution};
    static std::string cell(BudgetColumn column, int row) {
        static const double figures[][5] = {
            {50.00002, 1.5e-5, 12, 2, 3e-5}, {1e-3, 2e-5, 4, 3, 6e-5}, {0, 1.2e-5, 9, -1, 1.2e-5}};
        const double* line = figures[row];
        switch (column) {
            case BudgetColumn::quantity:
                return std::string(1, "pqr"[row]);
            case BudgetColumn::name:
                return "thing " + std::to_string(row);
            case BudgetColumn::value:
                return v(line[0]);
            case BudgetColumn::unit:
                return "mm";
            case BudgetColumn::standard:
                return v(line[1]);
            case BudgetColumn::nu:
                return v(line[2]);
            case BudgetColumn::c:
                return v(line[3]);
            case BudgetColumn::contribution:
                return v(line[4]);
            default:
                return "normal";
        }
    }
    static std::string head(BudgetColumn column, const char* language, std::size_t choice) {
        std::vector<std::string> heads;
        for (const BudgetWord& word : budget_words())
            if (word.column == column && word.language == std::string(language)) heads.push_back(word.words);
        return heads.at(choice % heads.size());
    }
    Rows rows(const char* language, std::size_t choice, int unknown, const std::string& unknown_head) const {
        Rows rows(4);
        for (std::size_t i = 0; i <= columns.size(); ++i) {
            if (static_cast<int>(i) == unknown) {
                rows[0].push_back(unknown_head);
                for (int row = 0; row < 3; ++row)
                    rows[static_cast<std::size_t>(row) + 1].push_back(v(0.25 + row));
            }
            if (i == columns.size()) break;
            rows[0].push_back(head(columns[i], language, choice));
            for (int row = 0; row < 3; ++row)
                rows[static_cast<std::size_t>(row) + 1].push_back(cell(columns[i], row));
        }
        return rows;
    }
    void expect_right(const Result<Proposals>& read, const std::string& what) const {
        ASSERT_TRUE(read) << what << ": " << read.error().message.english();
        const OutputResult y = first_order(*read).outputs.at(0);
        EXPECT_NEAR(y.estimate, 0.10000304, 1e-14) << what;
        EXPECT_NEAR(y.standard_uncertainty, 1e-9 * std::sqrt(900.0 + 3600.0 + 144.0), 1e-19) << what;
        EXPECT_NEAR(y.first_order.effective_degrees_of_freedom,
                    4644.0 * 4644.0 / (810000.0 / 12 + 12960000.0 / 4 + 20736.0 / 9), 1e-6)
            << what;
        EXPECT_EQ(all_found(*read).find("FIND OUT WHY"), std::string::npos) << what << "\n"
                                                                            << all_found(*read);
    }
};

TEST(BudgetHeads, SheetsInEveryLanguageAndOrderAreReadAndAnUnknownColumnIsAskedAbout) {
    std::mt19937 random(7);
    for (const char* language : languages)
        for (std::size_t choice = 0; choice < 12; ++choice) {
            GeneratedSheet sheet;
            std::shuffle(sheet.columns.begin(), sheet.columns.end(), random);
            const std::string what = std::string(language) + " " + std::to_string(choice);
            sheet.expect_right(read_rows(sheet.rows(language, choice, -1, "")), what);
            const int unknown = static_cast<int>(random() % (sheet.columns.size() + 1));
            for (const std::string& head : {std::string("Xyzzy"), std::string("")}) {
                const Rows rows = sheet.rows(language, choice, unknown, head);
                const auto asked = read_rows(rows);
                ASSERT_FALSE(asked) << what;
                EXPECT_EQ(asked.error().code, ErrorCode::usage) << what;
                const std::string words = asked.error().message.english();
                EXPECT_NE(words.find("column " + std::string(1, static_cast<char>('A' + unknown))),
                          std::string::npos)
                    << what << ": " << words;
                std::vector<std::string> stated;
                for (std::size_t i = 0; i <= sheet.columns.size(); ++i) {
                    if (static_cast<int>(i) == unknown) stated.emplace_back("-");
                    if (i < sheet.columns.size())
                        stated.emplace_back(i % 2 ? key_of(sheet.columns[i]) : as_headed);
                }
                sheet.expect_right(read_rows(rows, {.columns = stated}), what);
            }
        }
}

TEST(BudgetHeads, AColumnOfUnitsOrWordsIsAskedAboutToo) {
    const auto units = read_rows({{"Name", "Value", "Xyzzy", "u"}, {"a", v(1), "mm", v(0.3)}});
    ASSERT_FALSE(units);
    EXPECT_EQ(units.error().code, ErrorCode::usage);
    const std::vector<std::vector<std::string>> rows{{"Name", "Value", "Unit", "u", "Xyzzy"},
                                                     {"a", v(1), "mm", v(0.3), "rectangular"}};
    const auto words = read_rows(rows);
    ASSERT_FALSE(words);
    EXPECT_EQ(words.error().code, ErrorCode::usage);
    const auto stated = read_rows(rows, {.columns = {"?", "?", "?", "?", "-"}});
    ASSERT_TRUE(stated) << stated.error().message.english();
    const auto beside = read_rows({{"Name", "Value", "Unit", "u"}, {"a", v(1), "mm", v(0.3), "see page 7"}});
    EXPECT_TRUE(beside) << beside.error().message.english();
}

// A difference of temperatures in degrees Celsius, its coefficient in every form: always the same length.
TEST(BudgetTemperatures, DegreesCelsiusBesideACoefficientAreADifference) {
    for (const char* unit : {"K", "degC", "°C"})
        for (const std::string& c : {v(-575), std::string("-575 nm/K"), std::string("-575 nm/°C")})
            for (const double t : {0.0, 0.5}) {
                const auto read = read_rows(
                    {{"Quantity", "Estimate", "Unit", "Standard uncertainty", "c_i", "Contribution (nm)"},
                     {"l_S", v(50.00002), "mm", "15 nm", v(1), v(15)},
                     {"delta_t", v(t), unit, v(0.0289), c, v(16.6)}});
                ASSERT_TRUE(read) << unit << c << ": " << read.error().message.english();
                EXPECT_EQ(errors_of(*read), "");
                const OutputResult y = first_order(*read).outputs.at(0);
                EXPECT_NEAR(y.estimate, 1e-9 * (50000020.0 - 575.0 * t), 1e-16) << unit << c;
                EXPECT_NEAR(y.standard_uncertainty, 1e-9 * std::hypot(15.0, 575.0 * 0.0289), 1e-18)
                    << unit << c;
                const std::string said = all_found(*read);
                EXPECT_EQ(said.find("taken as a difference") != std::string::npos, unit != std::string("K"))
                    << said;
                EXPECT_NE(said.find("u(y) by its contributions"), std::string::npos) << said;
                EXPECT_EQ(said.find("FIND OUT WHY"), std::string::npos) << said;
            }
}

TEST(BudgetTemperatures, AResultInDegreesCelsiusIsAReading) {
    const auto read = read_rows({{"Quantity", "Estimate", "Unit", "Standard uncertainty", "c_i"},
                                 {"t_S", v(20.1), "°C", v(0.01), v(1)},
                                 {"d", v(0.03), "°C", v(0.02), v(-1)},
                                 {"t_X", v(20.07), "°C", v(0.0224), ""}});
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    const OutputResult y = first_order(*read).outputs.at(0);
    EXPECT_NEAR(y.estimate, 293.22, 1e-10);
    EXPECT_NEAR(y.standard_uncertainty, std::hypot(0.01, 0.02), 1e-12);
    EXPECT_EQ(all_found(*read).find("FIND OUT WHY"), std::string::npos) << all_found(*read);
}

/// M3003: limits, divisors, "vi or veff", and the sums in rows of their own that have a distribution too.
Rows m3003(double combined, double expanded) {
    return {{"Symbol", "Source of uncertainty", "Value (±)", "Units", "Probability distribution", "Divisor",
             "ci", "ui(y)", "vi or veff"},
            {"L", "Calibration of standard", v(0.03), "µm", "Normal", v(2), v(1), v(0.015), "∞"},
            {"D", "Drift", v(0.03), "µm", "Rectangular", "√3", v(1), v(0.0173), "∞"},
            {"R", "Repeatability", v(0.012), "µm", "Normal", v(1), v(1), v(0.012), v(4)},
            {"uc", "Combined standard uncertainty", "", "µm", "Normal", "", "", v(combined)},
            {"U", "Expanded uncertainty", "", "µm", "k=2", "", "", v(expanded)}};
}

TEST(BudgetOutcome, TheResultOfTheSheetIsHeldAgainstOurs) {
    const auto read = read_rows(m3003(0.0258, 0.052));
    ASSERT_TRUE(read) << read.error().message.english();
    const OutputResult y = first_order(*read).outputs.at(0);
    EXPECT_NEAR(y.standard_uncertainty, 1e-6 * std::sqrt(0.015 * 0.015 + 0.0003 + 0.012 * 0.012), 1e-15);
    EXPECT_NEAR(y.first_order.effective_degrees_of_freedom,
                std::pow(0.015 * 0.015 + 0.0003 + 0.012 * 0.012, 2) / (std::pow(0.012, 4) / 4), 1e-6);
    const std::string said = all_found(*read);
    for (const char* words : {"u(y): the file states 0.0258 µm", "U(y), k = 2: the file states 0.052 µm"})
        EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    EXPECT_EQ(said.find("FIND OUT WHY"), std::string::npos) << said;
    for (const auto& [combined, expanded] : {std::pair(0.0298, 0.052), std::pair(0.0258, 0.025)}) {
        const auto far = read_rows(m3003(combined, expanded));
        ASSERT_TRUE(far);
        EXPECT_NE(all_found(*far).find("FIND OUT WHY"), std::string::npos) << all_found(*far);
    }
}

TEST(BudgetOutcome, ARowOfSumsWithADistributionIsNoQuantity) {
    const auto read =
        read_rows({{"Name", "Unit", "Uncertainty", "Distribution", "Divisor", "Standard uncertainty"},
                   {"a", "mm", v(0.3), "normal", v(2), v(0.15)},
                   {"Combined standard uncertainty", "mm", "", "normal", "", v(0.15)},
                   {"Expanded uncertainty U", "mm", v(0.3), "normal", v(2), ""}});
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_NEAR(first_order(*read).outputs.at(0).standard_uncertainty, 1.5e-4, 1e-18);
    EXPECT_NE(all_found(*read).find("U(y), k = 2: the file states 0.3 mm"), std::string::npos)
        << all_found(*read);
}

TEST(BudgetOutcome, AnEffectiveAreaAndATotalStationAreQuantities) {
    const auto read = read_rows({{"Name", "Unit", "Standard uncertainty"},
                                 {"a", "mm", v(3)},
                                 {"Effective length", "mm", v(4)},
                                 {"Total station", "mm", v(12)}});
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_NEAR(first_order(*read).outputs.at(0).standard_uncertainty, 0.013, 1e-16);
}

TEST(BudgetMending, CellsAreReadAsStatedAndRowsLeftOut) {
    const Rows rows{{"Name", "Value", "Unit", "u"},
                    {"a", v(1), "mm", v(3)},
                    {"b", v(1), "mmm", v(4)},
                    {"d", "1,5", "mm", v(12)}};
    const auto unknown = read_rows(rows);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().line, 3);
    const auto comma = read_rows(rows, {.cells = {{"C3", "mm"}}});
    ASSERT_FALSE(comma);
    EXPECT_NE(comma.error().message.english().find("write 1.5, with a point"), std::string::npos)
        << comma.error().message.english();
    const auto mended = read_rows(rows, {.cells = {{"C3", "mm"}, {"B4", "1.5"}}});
    ASSERT_TRUE(mended) << mended.error().message.english();
    EXPECT_NEAR(first_order(*mended).outputs.at(0).standard_uncertainty, 0.013, 1e-16);
    EXPECT_NEAR(first_order(*mended).outputs.at(0).estimate, 0.0035, 1e-16);
    const auto without = read_rows(rows, {.cells = {{"B4", "1.5"}}, .rows_left_out = {3}});
    ASSERT_TRUE(without) << without.error().message.english();
    EXPECT_NEAR(first_order(*without).outputs.at(0).standard_uncertainty, 1e-3 * std::hypot(3.0, 12.0),
                1e-16);
    EXPECT_NE(all_found(*without).find("3 row 3 was left out"), std::string::npos) << all_found(*without);
    EXPECT_EQ(read_rows(rows, {.rows_left_out = {30}}).error().code, ErrorCode::usage);
    EXPECT_EQ(read_rows(rows, {.cells = {{"3C", "mm"}}}).error().code, ErrorCode::usage);
}

TEST(BudgetFigures, ATrapezoidIsNoNormalDistribution) {
    const auto read = read_rows(
        {{"Name", "Value", "Unit", "Limits", "Distribution"}, {"a", v(1), "mm", v(3), "trapezoidal"}});
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.english().find("'trapezoidal' is not known"), std::string::npos);
}

}  // namespace

}  // namespace covaria::budget_heads_test
