// A table of a model or an asset as people read it, and as files have it.
#include "core/text/cell.h"

#include <gtest/gtest.h>

namespace covaria::cell_test {
namespace {

std::string shown(const Table& table, std::size_t row, std::size_t column) {
    return to_unicode(written(table, table.columns.at(column), row, {}));
}

TEST(EvaluatedCell, IsInTheColumnsUnitOrSaysAnother) {
    Table made{"t", "T"};
    made.add("u").in(Unit::of("um")).symbol().figure(2);
    made.row({66.4e-6});
    made.row({Quantity{0.0664, Unit::of("mm")}});
    made.row({Quantity{66.4, Unit::of("um")}});
    made.row({std::string("a | b")});
    made.row({});
    const Table table = evaluation_table(made, {});
    EXPECT_EQ(to_unicode(head_written(table.columns[0], {})), "u / µm");
    EXPECT_EQ(shown(table, 0, 0), "66");
    EXPECT_EQ(shown(table, 1, 0), "0.066\u00a0mm");
    EXPECT_EQ(shown(table, 2, 0), "66");
    EXPECT_EQ(shown(table, 3, 0), "a | b");
    EXPECT_EQ(shown(table, 4, 0), "");
}

TEST(EvaluatedCell, TypedNumbersKeepTheirDigits) {
    Table made{"t", "T"};
    made.add("V").in(Unit::of("V"));
    made.add("n");
    made.row({Quantity{10.000172, Unit::of("V")}, 688.0});
    EXPECT_EQ(shown(made, 0, 0), "10.000\u202f172");
    EXPECT_EQ(shown(made, 0, 1), "688");
}

TEST(EvaluatedCell, AnEstimateMatchesItsUncertaintyByTheKeyOfTheColumn) {
    Table made{"t", "T"};
    made.add("x").in(Unit::of("mm")).estimate_of("u");
    made.add("u").in(Unit::of("mm")).figure(2);
    made.row({0.123456, 0.00012});
    EXPECT_EQ(shown(made, 0, 0), "123.46");
}

TEST(EvaluatedTable, APartOfOneIsInPerCentForPeopleOnly) {
    Table made{"t", "T"};
    made.add("change").percent(1);
    made.row({-0.5});
    const Table table = evaluation_table(made, {});
    EXPECT_EQ(to_unicode(head_written(table.columns[0], {})), "change / %");
    EXPECT_EQ(shown(table, 0, 0), "−50.0");
    EXPECT_EQ(exact_quantity(made.columns[0].cell(0))->value, -0.5);
}

TEST(EvaluatedTable, AResidueOfRoundingIsZero) {
    Table made{"t", "T"};
    made.add("x").in(Unit::of("mm")).figure(3);
    made.row({1.0});
    made.row({3e-17});
    EXPECT_EQ(exact_quantity(evaluation_table(made, {}).columns[0].cell(1))->value, 0.0);
}

TEST(FileTable, LivesLongerThanWhatItsColumnsRead) {
    Table held{"", ""};
    {
        const std::vector<double> numbers{1.5, 2.5};
        Table made{"t", "T", numbers.size()};
        made.add("x", [&numbers](std::size_t row) -> Cell { return numbers[row]; });
        made.add("seen", [](std::size_t) -> Cell { return Answer{true}; }).not_in_files();
        held = file_table(made);
    }
    ASSERT_EQ(held.columns.size(), 1u);
    EXPECT_EQ(exact_quantity(held.cell(1, "x"))->value, 2.5);
}

TEST(FileTable, WordsAreEnglishAndUnitsThoseOfTheView) {
    DisplayUnits units;
    units.choose(Unit::of("um"));
    EXPECT_EQ(english_of(Cell(Unit::of("mm")), units), "um");
    EXPECT_EQ(english_of(Cell(Answer{false})), "no");
    EXPECT_EQ(english_of(Cell(Symbols{"a", "b"})), "a, b");
    EXPECT_EQ(english_of(Cell(1.0)), "");
}

}  // namespace
}  // namespace covaria::cell_test
