// Cells of set-up tables as text; addresses of set-ups; edits of components.
#include "ui/document/setup_cells.h"

#include <gtest/gtest.h>

#include "core/project/component_edit.h"
#include "ui/document/setup_address.h"

namespace covaria::ui::setup_cells_test {
namespace {

const QLocale locale = QLocale::c();

TEST(SetupCells, ReadsCellsByTheirKind) {
    const ColumnSpec number{.key = "x", .title = "x", .unit = Unit::of("mm")};
    EXPECT_EQ(parse_cell(number, Unit::of("mm"), "500 um", locale), SetupCell(0.5));
    EXPECT_EQ(parse_cell(number, Unit::of("um"), "3", locale), SetupCell(3.0));
    EXPECT_EQ(parse_cell(number, Unit::of("mm"), " ", locale), SetupCell());
    EXPECT_FALSE(parse_cell(number, Unit::of("mm"), "three", locale));

    const ColumnSpec count{.key = "n", .title = "n", .kind = FieldKind::integer, .range = {1.0, 6.0}};
    EXPECT_EQ(parse_cell(count, Unit(), "6", locale), SetupCell(6.0));
    EXPECT_FALSE(parse_cell(count, Unit(), "2.5", locale));
    EXPECT_FALSE(parse_cell(count, Unit(), "7", locale));

    const ColumnSpec choice{
        .key = "c", .title = "c", .kind = FieldKind::choice, .choices = {{"a", "First"}, {"b", "Second"}}};
    EXPECT_EQ(parse_cell(choice, Unit(), "second", locale), SetupCell(std::string("b")));
    EXPECT_EQ(cell_text(choice, SetupCell(std::string("a")), locale), "First");
    EXPECT_FALSE(parse_cell(choice, Unit(), "third", locale));

    const ColumnSpec flag{.key = "f", .title = "f", .kind = FieldKind::flag};
    EXPECT_EQ(parse_cell(flag, Unit(), "Yes", locale), SetupCell(true));
    EXPECT_FALSE(parse_cell(flag, Unit(), "maybe", locale));
}

TEST(SetupCells, RangesAreSaidInTheUnitOfTheCell) {
    const QString complaint = range_complaint({0.0, 0.01}, 0.02, Unit::of("mm"), locale);
    EXPECT_TRUE(complaint.contains("10 mm")) << complaint.toStdString();
    EXPECT_TRUE(range_complaint({0.0, 0.01}, 0.01, Unit::of("mm"), locale).isEmpty());
    EXPECT_FALSE(range_complaint({0.0, 1.0, true}, 0.0, Unit(), locale).isEmpty());
}

TEST(SetupAddress, PathsAndEntriesCorrespond) {
    Project project;
    project.assets = {{"a", "kind", "A", {}, {}}, {"b", "kind", "B", {}, {}}};
    project.analyses.push_back({"x", "model", "X", {}, {}, {}, {}, {}, {}});
    const SetupAddress b{SetupOwner::asset, "b"};
    EXPECT_EQ(setup_path(project, b), "/assets/1/setup");
    EXPECT_EQ(address_of_path(project, "/assets/1/setup/points/rows/2"), b);
    EXPECT_EQ(address_of_path(project, "/analyses/0"), (SetupAddress{SetupOwner::analysis, "x"}));
    EXPECT_TRUE(address_of_path(project, "/assets/7/setup").id.empty());
    EXPECT_TRUE(address_of_path(project, "/title").id.empty());
    EXPECT_EQ(find_setup(project, SetupAddress{SetupOwner::asset, "gone"}), nullptr);
}

TEST(InputEdits, ComponentsKeepTheirQuantityThroughUnits) {
    UncertaintyComponent component;
    component.name = "certificate";
    component.unit = Unit::of("um");
    component.distribution = Distribution::of(Rectangular{-2e-6, 2e-6});
    const ComponentEdit edit = to_edit(component);
    EXPECT_EQ(edit.distribution, "rectangular");
    EXPECT_EQ(edit.parameters, (std::vector<double>{-2.0, 2.0}));
    EXPECT_FALSE(edit.degrees_of_freedom);
    const ComponentEdit millimetres = in_unit(edit, Unit::of("mm"));
    EXPECT_EQ(millimetres.parameters, (std::vector<double>{-0.002, 0.002}));
    const auto back = distribution_of(millimetres);
    ASSERT_TRUE(back);
    EXPECT_DOUBLE_EQ(back->standard_uncertainty(), component.distribution.standard_uncertainty());
    EXPECT_FALSE(distribution_of({.name = "", .distribution = "no such kind", .parameters = {}}));
}

}  // namespace
}  // namespace covaria::ui::setup_cells_test
