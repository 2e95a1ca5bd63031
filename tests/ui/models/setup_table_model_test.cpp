// A table of a set-up as a spreadsheet.
#include "ui/models/setup_table_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "core/project/kind_lookup.h"
#include "tests/ui/qt_application.h"
#include "tests/ui/sample_schema.h"
#include "ui/document/quantity_text.h"
#include "ui/models/cell_blocks.h"
#include "ui/models/roles.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui::setup_table_model_test {
namespace {

struct SetupTableModelTest : testing::Test {
    SetupTableModelTest() { document.replace(sample_project()); }
    QString text(int row, int column) const { return model.index(row, column).data().toString(); }
    bool type(int row, int column, const QString& value) {
        return model.setData(model.index(row, column), value);
    }
    const SetupTable& stored() const {
        return std::get<SetupTable>(document.project().assets[0].setup.values.at("points"));
    }
    Problems found;
    Document document{[this](const MadeProject&) { return found; }, nullptr};
    SetupTableModel model{document, sample_address(), &sample_schema(), "points"};
    QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(SetupTableModelTest, ShowsCellsWithUnitsInTheHeads) {
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_EQ(text(1, 0), "b2");
    EXPECT_EQ(text(1, 1), "2");
    EXPECT_EQ(text(1, 3), "Nest");
    EXPECT_EQ(model.headerData(1, Qt::Horizontal).toString(), "x / mm");
    EXPECT_TRUE(model.headerData(2, Qt::Horizontal).toString().endsWith(QString::fromUtf8("/ µm")));
    EXPECT_TRUE(model.index(0, 1).data(Qt::TextAlignmentRole).toInt() & Qt::AlignRight);
    EXPECT_EQ(model.index(1, 2).data(path_role).toString(), "/assets/0/setup/points/rows/1/2");
}

/// The table of quantities says θ where the budget and the equation do.
TEST(SetupTableModelSymbols, NamesOfQuantitiesAreSymbols) {
    const LoadedProject loaded = load_project(data_directory() / "projects/gum/h1-end-gauge.covaria");
    Document document{[](const MadeProject&) { return Problems(); }, nullptr};
    document.replace(loaded.project);
    const SetupAddress address{SetupOwner::analysis, "table"};
    const SetupTableModel quantities{document, address, schema_of(*loaded.project.find_analysis("table")),
                                     "quantities"};
    QStringList shown;
    for (int row = 0; row < quantities.rowCount(); ++row) {
        EXPECT_EQ(quantities.index(row, 0).data().toString().contains(QLatin1Char('_')), row != 1 && row != 3)
            << "what is edited and copied stays as it was typed";
        const QVariant typeset = quantities.index(row, 0).data(typeset_role);
        ASSERT_TRUE(typeset.isValid());
        shown << to_qt(to_unicode(typeset.value<Text>()));
        EXPECT_FALSE(quantities.index(row, 1).data(typeset_role).isValid()) << "names are words";
    }
    EXPECT_EQ(shown[3], QStringLiteral("θ"));
}

// "23 degC" typed for a quantity in K is no difference of 296.15 K; typed for one in degC, K is
// thermodynamic.
TEST(SetupTableModelUnits, ATemperatureTypedForADifferenceStaysInItsCell) {
    LoadedProject loaded =
        parse_project(R"json({"format": "covaria", "schemaVersion": 2, "title": "", "assets": [],
        "analyses": [{"id": "a", "model": "measurement-equation", "setup": {"equations": ["y = t + d"],
        "quantities": {"columns": ["symbol", "value", "unit"], "rows": [["t", 20, "degC"], ["d", 3, "K"]]}}}]})json",
                      {}, "temperatures");
    Document document{[](const MadeProject&) { return Problems(); }, nullptr};
    document.replace(loaded.project);
    const SetupSchema* schema = schema_of(document.project().analyses[0]);
    SetupTableModel quantities{document, {SetupOwner::analysis, "a"}, schema, "quantities"};
    const int value = static_cast<int>(SetupSchema::column(*schema->find("quantities"), "value"));
    const auto type = [&](int row, const char* text) {
        quantities.setData(quantities.index(row, value), QString::fromUtf8(text));
        return quantities.index(row, value).data(Qt::EditRole).toString();
    };
    EXPECT_EQ(type(1, "23 °C"), QString::fromUtf8("23 °C"));
    EXPECT_TRUE(quantities.index(1, value)
                    .data(problem_role)
                    .toString()
                    .contains(QStringLiteral("may be a difference")));
    EXPECT_EQ(document.undo_stack().count(), 0) << "nothing was converted";
    EXPECT_EQ(type(1, "500 mK"), QStringLiteral("0.5"));
    EXPECT_EQ(type(0, "294.15 K"), QStringLiteral("21"));
}

TEST_F(SetupTableModelTest, EditsGoThroughTheDocumentAndComeBack) {
    EXPECT_TRUE(type(0, 1, "500 um"));
    EXPECT_EQ(stored().rows[0][1], SetupCell(0.5));
    EXPECT_EQ(text(0, 1), "0.5");
    EXPECT_TRUE(type(0, 3, "Target"));
    EXPECT_EQ(stored().rows[0][3], SetupCell(std::string("b")));
    document.undo_stack().undo();
    document.undo_stack().undo();
    EXPECT_EQ(text(0, 1), "1");
    EXPECT_EQ(document.project(), sample_project());
}

TEST_F(SetupTableModelTest, WhatIsNotUnderstoodIsMarkedAndNotLost) {
    EXPECT_TRUE(type(0, 1, "one"));
    EXPECT_EQ(text(0, 1), "one");
    EXPECT_FALSE(model.index(0, 1).data(problem_role).toString().isEmpty());
    EXPECT_TRUE(model.index(0, 1).data(Qt::BackgroundRole).isValid());
    EXPECT_EQ(document.undo_stack().count(), 0);
    model.insertRows(0, 2);
    EXPECT_EQ(text(2, 1), "one") << "the mark moves with its row";
    EXPECT_TRUE(type(2, 1, "7"));
    EXPECT_TRUE(model.index(2, 1).data(problem_role).toString().isEmpty());
}

TEST_F(SetupTableModelTest, UndoTakesBackWhatCannotBeRead) {
    const QString first = text(0, 1), second = text(1, 1);
    EXPECT_TRUE(type(0, 1, "3"));
    QCoreApplication::processEvents();  // nobody types two cells at once
    EXPECT_TRUE(type(1, 1, "abc"));
    ASSERT_TRUE(document.can_undo());
    document.undo();
    EXPECT_EQ(text(1, 1), second) << "typed last, taken back first";
    EXPECT_EQ(text(0, 1), "3") << "the step before stands";
    EXPECT_TRUE(document.unread().all().empty());
    document.undo();
    EXPECT_EQ(text(0, 1), first);
    EXPECT_FALSE(document.can_undo());
}

TEST_F(SetupTableModelTest, UndoOfAPasteTakesBackWhatWasRefusedOfIt) {
    const QString first = text(0, 1), second = text(1, 1);
    EXPECT_EQ(model.paste(model.index(0, 1), QStringLiteral("3\nabc")), 1);
    QCoreApplication::processEvents();
    EXPECT_EQ(text(1, 1), "abc");
    document.undo();
    EXPECT_EQ(text(0, 1), first);
    EXPECT_EQ(text(1, 1), second);
    EXPECT_TRUE(document.unread().all().empty());
    EXPECT_FALSE(document.can_undo());
}

TEST_F(SetupTableModelTest, InsertsAndRemovesRows) {
    QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    EXPECT_TRUE(model.insertRows(1, 2));
    EXPECT_EQ(model.rowCount(), 5);
    EXPECT_EQ(inserted.count(), 1);
    EXPECT_EQ(text(1, 3), "Nest") << "a choice starts with its first";
    EXPECT_EQ(text(1, 1), "");
    EXPECT_TRUE(model.removeRows(0, 3));
    EXPECT_EQ(text(0, 0), "b2");
    EXPECT_FALSE(model.removeRows(1, 5));
    document.undo_stack().undo();
    document.undo_stack().undo();
    EXPECT_EQ(document.project(), sample_project());
    EXPECT_EQ(model.rowCount(), 3);
    EXPECT_EQ(reset.count(), 0) << "views keep their selection";
}

TEST_F(SetupTableModelTest, PastesABlockAsOneStep) {
    EXPECT_EQ(model.paste(model.index(2, 1), "7\t8\tTarget\r\n9\t10 nm\tNest\textra\r\n"), 0);
    EXPECT_EQ(document.undo_stack().count(), 1);
    ASSERT_EQ(model.rowCount(), 4);
    EXPECT_EQ(text(2, 1), "7");
    EXPECT_EQ(text(2, 3), "Target");
    EXPECT_EQ(stored().rows[3][2], SetupCell(0.01));
    document.undo_stack().undo();
    EXPECT_EQ(document.project(), sample_project());
}

TEST_F(SetupTableModelTest, PastedCellsThatAreNotUnderstoodAreCountedAndMarked) {
    EXPECT_EQ(model.paste(model.index(2, 1), "7;oops\n8;-1"), 2);
    EXPECT_EQ(text(2, 2), "oops");
    EXPECT_EQ(text(3, 2), "-1") << "in a row that the paste added";
    EXPECT_EQ(stored().rows[3][1], SetupCell(8.0));
}

TEST_F(SetupTableModelTest, FillsDownAndClears) {
    QModelIndexList cells;
    for (int row = 0; row < 3; ++row)
        for (int column : {1, 2}) cells << model.index(row, column);
    model.fill_down(cells);
    EXPECT_EQ(text(2, 1), "1");
    EXPECT_EQ(text(2, 2), "10");
    model.clear({model.index(1, 1), model.index(1, 3)});
    EXPECT_EQ(text(1, 1), "");
    EXPECT_EQ(document.undo_stack().count(), 2);
}

TEST_F(SetupTableModelTest, CopiesWhatPasteReads) {
    QModelIndexList cells;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column) cells << model.index(row, column);
    EXPECT_EQ(block_text(cells), "b1\t1\t10\nb2\t2\t20\n");
    model.paste(model.index(1, 0), block_text(cells));
    EXPECT_EQ(text(2, 0), "b2");
    EXPECT_EQ(text(1, 2), "10");
}

TEST_F(SetupTableModelTest, ChangingTheUnitKeepsTheQuantities) {
    QSignalSpy heads(&model, &QAbstractItemModel::headerDataChanged);
    model.set_unit(1, Unit::of("m"));
    EXPECT_EQ(text(2, 1), "0.003");
    EXPECT_EQ(model.headerData(1, Qt::Horizontal).toString(), "x / m");
    EXPECT_GT(heads.count(), 0);
    model.set_unit(1, Unit::of("kg"));
    EXPECT_EQ(text(2, 1), "0.003");
}

TEST_F(SetupTableModelTest, ALinkedTableIsReadOnlyUntilTakenIntoTheProject) {
    Project linked = sample_project();
    std::get<SetupTable>(linked.assets[0].setup.values["points"]).csv_file = "points.csv";
    document.replace(linked);
    EXPECT_TRUE(model.is_linked());
    EXPECT_FALSE(type(0, 1, "5"));
    EXPECT_FALSE(model.insertRows(0, 1));
    EXPECT_FALSE(model.flags(model.index(0, 1)) & Qt::ItemIsEditable);
    model.embed();
    EXPECT_FALSE(model.is_linked());
    EXPECT_TRUE(type(0, 1, "5"));
    EXPECT_TRUE(stored().csv_file.empty());
}

TEST_F(SetupTableModelTest, ProblemsAreShownAtTheirCells) {
    found.error("/assets/0/setup/points/rows/1/x", "too far away");
    found.error("/assets/0/setup/points/rows/2", "on a line with the others");
    document.check_now();
    EXPECT_EQ(model.index(1, 1).data(problem_role).toString(), "too far away");
    EXPECT_EQ(model.index(1, 1).data(Qt::ToolTipRole).toString(), "too far away");
    EXPECT_TRUE(model.index(0, 1).data(problem_role).toString().isEmpty());
    EXPECT_EQ(model.headerData(2, Qt::Vertical, Qt::ToolTipRole).toString(), "on a line with the others");
    EXPECT_EQ(model.index_of_path("/rows/1/x"), model.index(1, 1));
    EXPECT_EQ(model.index_of_path("/rows/1/2"), model.index(1, 2));
    EXPECT_FALSE(model.index_of_path("/rows/9/2").isValid());
}

TEST_F(SetupTableModelTest, SurvivesTheRemovalOfItsEntry) {
    document.apply("Delete", [](Project& project) { project.assets.clear(); });
    EXPECT_EQ(model.rowCount(), 0);
    document.undo_stack().undo();
    EXPECT_EQ(model.rowCount(), 3);
}

TEST(TableText, ReadsWhatOtherProgramsWrite) {
    const QLocale english = QLocale::c();
    const QLocale german(QLocale::German, QLocale::Germany);
    EXPECT_EQ(parse_block("a,b\nc,d", english), (std::vector<QStringList>{{"a", "b"}, {"c", "d"}}));
    EXPECT_EQ(parse_block("1,5;2", german), (std::vector<QStringList>{{"1,5", "2"}}));
    EXPECT_EQ(parse_block("1,5\n2,5", german), (std::vector<QStringList>{{"1,5"}, {"2,5"}}));
    EXPECT_EQ(parse_block("\"x\ty\"\t\"say \"\"hi\"\"\"\n", english),
              (std::vector<QStringList>{{"x\ty", "say \"hi\""}}));
    EXPECT_EQ(parse_block("a\t\r\n\tb\r\n", english), (std::vector<QStringList>{{"a", ""}, {"", "b"}}));
    EXPECT_TRUE(parse_block("", english).empty());
}

}  // namespace
}  // namespace covaria::ui::setup_table_model_test
