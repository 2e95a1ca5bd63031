// The budget as it is typed: statements with their units in one cell, and what comes of them beside.
#include "ui/models/budget_sheet_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QColor>
#include <QGuiApplication>
#include <QPalette>
#include <cmath>
#include <tuple>

#include "core/made/made_project.h"
#include "core/propagation/engine.h"
#include "core/text/symbol.h"
#include "tests/ui/qt_application.h"
#include "ui/document/observation_edits.h"
#include "ui/models/budget_foot_model.h"
#include "ui/models/cell_blocks.h"
#include "ui/models/roles.h"
#include "ui/theme/strings.h"

namespace covaria::ui::budget_sheet_model_test {
namespace {

using Section = BudgetSheetModel::Section;

Project equation_project() {
    AnalysisEntry analysis;
    analysis.id = "budget";
    analysis.model = "measurement-equation";
    analysis.setup.values["equations"] = std::string("l = l_S + d");
    Project project;
    project.analyses = {analysis};
    return project;
}

struct BudgetSheetModelTest : testing::Test {
    BudgetSheetModelTest() {
        document.replace(equation_project());
        const SetupAddress address{SetupOwner::analysis, "budget"};
        const FieldSpec* field = find_schema(document.project(), address)->find("quantities");
        model = std::make_unique<BudgetSheetModel>(document, address, *field);
        tester = std::make_unique<QAbstractItemModelTester>(
            model.get(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    }
    QString text(int row, Section section) const { return model->index(row, section).data().toString(); }
    QString problem(int row, Section section) const {
        return model->index(row, section).data(problem_role).toString();
    }
    bool type(int row, Section section, const char* value) {
        return model->setData(model->index(row, section), QString::fromUtf8(value));
    }
    SetupCell stored(int row, const char* key) const {
        const SetupTable& table = model->sheet().table();
        return table.rows[std::size_t(row)][SetupSchema::column(*model->sheet().field(), key)];
    }
    /// Results of the project as it is now.
    void evaluate() {
        const auto made = MadeProject::make(document.project());
        const auto analysis = made->analysis("budget");
        ASSERT_TRUE(analysis) << first_error(made->problems(), "");
        auto result = evaluate_first_order(*analysis->propagated, analysis->options);
        ASSERT_TRUE(result);
        shown = std::make_shared<const UncertaintyResult>(std::move(*result));
        model->set_result(shown, 0, true);
    }
    Document document{[](const MadeProject&) { return Problems{}; }, nullptr};
    std::unique_ptr<BudgetSheetModel> model;
    std::shared_ptr<const UncertaintyResult> shown;
    std::unique_ptr<QAbstractItemModelTester> tester;
};

TEST_F(BudgetSheetModelTest, IsTypedFromNothing) {
    ASSERT_EQ(model->rowCount(), 1) << "a row to type into";
    ASSERT_TRUE(type(0, Section::symbol, "l_S"));
    ASSERT_TRUE(type(0, Section::estimate, "50.000623 mm"));
    ASSERT_TRUE(type(0, Section::stated, "25 nm nu 18"));
    EXPECT_EQ(stored(0, "unit"), SetupCell(std::string("mm")));
    EXPECT_EQ(stored(0, "value"), SetupCell(50.000623));
    EXPECT_EQ(stored(0, "statement"), SetupCell(std::string("standard")));
    EXPECT_EQ(stored(0, "a"), SetupCell(25.0)) << "as the certificate says it";
    EXPECT_EQ(stored(0, "stated_unit"), SetupCell(std::string("nm")));
    EXPECT_EQ(text(0, Section::stated), QStringLiteral("u = 25 nm"));
    EXPECT_EQ(stored(0, "nu"), SetupCell(18.0));
    ASSERT_EQ(model->rowCount(), 2);
    EXPECT_EQ(document.undo_stack().count(), 3) << "a cell is one step";
    type(1, Section::symbol, "d");
    type(1, Section::estimate, "215 nm");
    type(1, Section::stated, "U = 0.0194 um, k = 2");
    evaluate();
    EXPECT_EQ(text(0, Section::u), QString::fromUtf8("0.000\u202f025")) << "as 50.000 623";
    EXPECT_EQ(text(1, Section::u), QStringLiteral("9.7"));
    EXPECT_EQ(text(1, Section::distribution), QStringLiteral("normal"));
    EXPECT_EQ(text(1, Section::type), QStringLiteral("B"));
    EXPECT_EQ(text(1, Section::stated), QString::fromUtf8("U = 0.0194 µm, k = 2"));
    const double share = model->index(0, Section::share).data(exact_role).toDouble();
    EXPECT_NEAR(share, 100.0 * 25.0 * 25.0 / (25.0 * 25.0 + 9.7 * 9.7), 1e-10) << "in % as the head says";
}

TEST_F(BudgetSheetModelTest, TheResultStandsBelowItsRows) {
    BudgetFootModel foot;
    QAbstractItemModelTester tests(&foot);
    EXPECT_EQ(foot.rowCount(), 0) << "nothing is evaluated";
    type(0, Section::symbol, "l_S");
    type(0, Section::estimate, "50.000623 mm");
    type(0, Section::stated, "25 nm nu 18");
    type(1, Section::symbol, "d");
    type(1, Section::estimate, "215 nm");
    type(1, Section::stated, "9.7 nm");
    evaluate();
    foot.set_result(shown, 0, true, {}, 2);
    ASSERT_EQ(foot.rowCount(), 1);
    ASSERT_EQ(foot.columnCount(), model->columnCount());
    const auto words = [&foot](int section) { return foot.index(0, section).data().toString(); };
    const OutputResult& of = shown->outputs[0];
    EXPECT_EQ(words(Section::symbol), to_qt(symbol_to_unicode(of.quantity.symbol)));
    EXPECT_EQ(words(Section::unit), QStringLiteral("mm"));
    // sqrt(25^2 + 9.7^2) nm = 26.8 nm
    EXPECT_EQ(words(Section::u), QString::fromUtf8("0.000\u202f027"));
    EXPECT_EQ(words(Section::contribution), QStringLiteral("27")) << "in nm, as the cells above";
    EXPECT_EQ(words(Section::share), QStringLiteral("100"));
    EXPECT_EQ(words(Section::nu), QStringLiteral("23.8")) << "(25^2 + 9.7^2)^2 / (25^4 / 18), cut off";
    EXPECT_TRUE(words(Section::stated).startsWith(QStringLiteral("U = ")))
        << words(Section::stated).toStdString();
    foot.set_result(nullptr, 0, true, {}, 2);
    EXPECT_EQ(foot.rowCount(), 0);
}

TEST_F(BudgetSheetModelTest, AListIsTheObservationsOfItsRow) {
    type(0, Section::symbol, "l_S");
    type(0, Section::estimate, "50 mm");
    type(1, Section::symbol, "d");
    type(1, Section::estimate, "215 nm");
    const int steps = document.undo_stack().count();
    ASSERT_TRUE(type(1, Section::stated, "0.21; 0.22; 0.215 um"));
    EXPECT_EQ(document.undo_stack().count(), steps + 1);
    EXPECT_EQ(problem(1, Section::stated), QString());
    EXPECT_EQ(text(1, Section::stated), QStringLiteral("observations 210; 220; 215"));
    EXPECT_EQ(stored(1, "value"), SetupCell()) << "it is their mean";
    const SetupAddress address{SetupOwner::analysis, "budget"};
    EXPECT_EQ(observations_of(document.project(), address, "d"), (std::vector<double>{210, 220, 215}));
    EXPECT_TRUE(observations_of(document.project(), address, "l_S").empty());
    evaluate();
    EXPECT_EQ(text(1, Section::estimate), QStringLiteral("215.0")) << "computed: to the digits of its u";
    EXPECT_EQ(text(1, Section::u), QStringLiteral("2.9")) << "5/sqrt(3)";
    EXPECT_EQ(text(1, Section::type), QStringLiteral("A"));
    EXPECT_EQ(text(1, Section::nu), QStringLiteral("2"));
    // Observations of another quantity stay as they are; new ones take the place of the old.
    type(0, Section::stated, "1; 2; 3");
    type(1, Section::stated, "210; 220; 230; 240");
    EXPECT_EQ(text(1, Section::stated), QString::fromUtf8("observations 210; 220 … (4)"));
    EXPECT_EQ(model->index(1, Section::stated).data(Qt::EditRole).toString(),
              QStringLiteral("observations 210; 220; 230; 240"));
    EXPECT_EQ(block_text({model->index(1, Section::stated)}),
              QStringLiteral("observations 210; 220; 230; 240\n"))
        << "as it can be pasted back";
    EXPECT_EQ(observations_of(document.project(), address, "l_S"), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(observations_of(document.project(), address, "d"), (std::vector<double>{210, 220, 230, 240}));
    document.undo();
    EXPECT_EQ(text(1, Section::stated), QStringLiteral("observations 210; 220; 215"))
        << "the cell follows a table that is not its own";
    type(2, Section::stated, "1; 2; 3");
    EXPECT_NE(problem(2, Section::stated), QString()) << "of what?";
}

TEST_F(BudgetSheetModelTest, AFurtherComponentIsShownInTheUnitOfItsRow) {
    type(0, Section::symbol, "l_S");
    type(0, Section::estimate, "50 mm");
    type(1, Section::symbol, "d");
    type(1, Section::estimate, "215 nm");
    type(1, Section::stated, "5.8 nm");
    type(2, Section::symbol, "d");
    type(2, Section::unit, "um");
    type(2, Section::stated, "U = 0.01 um, k = 2");
    evaluate();
    EXPECT_EQ(text(2, Section::unit), QStringLiteral("µm"));
    EXPECT_EQ(text(2, Section::estimate), QString()) << "that of the quantity stands once, above";
    EXPECT_EQ(text(2, Section::u), QStringLiteral("0.0050"));
}

TEST_F(BudgetSheetModelTest, WhatWasRefusedIsReadAgainInTheNewUnit) {
    type(0, Section::symbol, "theta");
    type(0, Section::estimate, "1 nm");
    type(0, Section::estimate, "-0.1 K");
    ASSERT_FALSE(problem(0, Section::estimate).isEmpty());
    type(0, Section::unit, "K");
    EXPECT_EQ(problem(0, Section::estimate), QString());
    EXPECT_EQ(stored(0, "value"), SetupCell(-0.1));
}

/// Typed before the units: each is read in its own row's unit, and none takes another along.
TEST_F(BudgetSheetModelTest, WhatWasRefusedInOneRowStaysWhenAnotherIsMended) {
    type(0, Section::symbol, "d");
    type(0, Section::stated, "rect 5 nm");
    type(1, Section::symbol, "alpha");
    type(1, Section::stated, "2e-6 1/K");
    ASSERT_FALSE(problem(0, Section::stated).isEmpty());
    ASSERT_FALSE(problem(1, Section::stated).isEmpty());
    type(0, Section::unit, "nm");
    EXPECT_EQ(problem(0, Section::stated), QString());
    EXPECT_EQ(text(0, Section::stated), QString::fromUtf8("rectangular ± 5 nm"));
    EXPECT_FALSE(problem(1, Section::stated).isEmpty());
    EXPECT_EQ(text(1, Section::stated), QStringLiteral("2e-6 1/K"));
    type(1, Section::unit, "1/K");
    EXPECT_EQ(text(1, Section::stated), QStringLiteral("u = 2×10⁻⁶ 1/K"));
}

/// The set-up shows the same table: neither view takes texts from the other, whichever is told first.
TEST_F(BudgetSheetModelTest, AnotherViewOfTheTableHasTheSameRefusedTexts) {
    const SetupAddress address{SetupOwner::analysis, "budget"};
    SetupTableModel other(document, address, "quantities");
    const int statement = int(SetupSchema::column(*other.field(), "statement"));
    type(0, Section::symbol, "d");
    type(0, Section::stated, "5 nm");
    type(1, Section::symbol, "alpha");
    type(1, Section::stated, "2e-6 1/K");
    EXPECT_TRUE(other.is_refused(0, statement) && other.is_refused(1, statement));
    type(0, Section::unit, "nm");
    EXPECT_FALSE(other.is_refused(0, statement));
    EXPECT_TRUE(other.is_refused(1, statement));
    EXPECT_EQ(text(1, Section::stated), QStringLiteral("2e-6 1/K"));
    ASSERT_TRUE(other.insertRow(0));
    EXPECT_EQ(text(2, Section::stated), QStringLiteral("2e-6 1/K"));
    EXPECT_TRUE(other.is_refused(2, statement));
    EXPECT_FALSE(other.is_refused(1, statement));
    ASSERT_TRUE(model->removeRow(0));
    EXPECT_TRUE(other.is_refused(1, statement));
    EXPECT_EQ(document.unread().all().size(), 1u);
    type(1, Section::unit, "1/K");
    EXPECT_TRUE(document.unread().all().empty());
    EXPECT_FALSE(other.is_refused(1, statement));
}

/// Wherever it is typed.
TEST_F(BudgetSheetModelTest, TheSetUpReadsAValueWithItsUnitToo) {
    SetupTableModel table(document, {SetupOwner::analysis, "budget"}, "quantities");
    type(0, Section::symbol, "d");
    const auto at = [&](const char* key) {
        return table.index(0, int(SetupSchema::column(*table.field(), key)));
    };
    ASSERT_TRUE(table.setData(at("value"), QStringLiteral("50 mm")));
    EXPECT_EQ(text(0, Section::estimate), QStringLiteral("50"));
    EXPECT_EQ(text(0, Section::unit), QStringLiteral("mm"));
    table.setData(at("value"), QStringLiteral("1 m"));
    EXPECT_EQ(stored(0, "value"), SetupCell(1000.0));
    table.setData(at("value"), QStringLiteral("1 s"));
    EXPECT_FALSE(problem(0, Section::estimate).isEmpty());
}

/// 4.990 was typed: its zero says how well it was read.
TEST_F(BudgetSheetModelTest, ObservationsKeepTheirZeros) {
    type(0, Section::symbol, "l_S");
    type(0, Section::unit, "mm");
    type(0, Section::stated, "4.990; 5.012; 5.000");
    EXPECT_EQ(text(0, Section::stated), QStringLiteral("observations 4.990; 5.012; 5.000"));
    EXPECT_EQ(model->index(0, Section::stated).data(Qt::EditRole).toString(),
              QStringLiteral("observations 4.990; 5.012; 5.000"));
    const SetupAddress address{SetupOwner::analysis, "budget"};
    SetupTableModel table{document, address, find_schema(document.project(), address), "observations"};
    const int value = int(SetupSchema::column(*table.field(), "value"));
    EXPECT_EQ(table.index(0, value).data().toString(), QStringLiteral("4.990"));
    table.setData(table.index(0, value), QStringLiteral("4.9901"));
    EXPECT_EQ(table.index(1, value).data().toString(), QStringLiteral("5.0120"))
        << "the column has the decimals of the one with the most";
}

/// "4.0 kg" does so as an estimate.
/// JCGM 100 7.2.2: u of the last digits in parentheses, or u itself.
TEST_F(BudgetSheetModelTest, AnEstimateMayBringItsStandardUncertainty) {
    ASSERT_TRUE(type(0, Section::symbol, "l_S"));
    ASSERT_TRUE(type(0, Section::estimate, "50.000 623(25) mm"));
    EXPECT_DOUBLE_EQ(std::get<double>(stored(0, "value")), 50.000623);
    EXPECT_EQ(std::get<std::string>(stored(0, "unit")), "mm");
    EXPECT_EQ(std::get<std::string>(stored(0, "statement")), "standard");
    EXPECT_DOUBLE_EQ(std::get<double>(stored(0, "a")), 0.000025);
    ASSERT_TRUE(type(0, Section::estimate, "50.5(0.2)"));
    EXPECT_DOUBLE_EQ(std::get<double>(stored(0, "value")), 50.5);
    EXPECT_DOUBLE_EQ(std::get<double>(stored(0, "a")), 0.2);
    ASSERT_TRUE(type(0, Section::estimate, "5(1) cm"));
    EXPECT_DOUBLE_EQ(std::get<double>(stored(0, "value")), 50.0) << "in the unit of the row";
    EXPECT_DOUBLE_EQ(Unit::parse(std::get<std::string>(stored(0, "stated_unit")))
                         ->interval_to_si(std::get<double>(stored(0, "a"))),
                     0.01);
    type(0, Section::estimate, "5(1) s");
    EXPECT_FALSE(problem(0, Section::estimate).isEmpty());
    EXPECT_DOUBLE_EQ(Unit::parse(std::get<std::string>(stored(0, "stated_unit")))
                         ->interval_to_si(std::get<double>(stored(0, "a"))),
                     0.01)
        << "nothing of it is taken";
}

TEST_F(BudgetSheetModelTest, AListGivesItsRowTheUnit) {
    type(0, Section::symbol, "a");
    type(0, Section::stated, "10.12; 10.15; 10.11 mm");
    EXPECT_EQ(problem(0, Section::stated), QString());
    EXPECT_EQ(text(0, Section::unit), QStringLiteral("mm"));
    EXPECT_EQ(text(0, Section::stated), QStringLiteral("observations 10.12; 10.15; 10.11"));
    type(1, Section::symbol, "b");
    type(1, Section::unit, "s");
    type(1, Section::stated, "10.12; 10.15; 10.11 mm");
    EXPECT_FALSE(problem(1, Section::stated).isEmpty());
}

/// Another statement drops the degrees of freedom of the one before, also where its distribution is
/// rectangular; a mended figure keeps them.
TEST_F(BudgetSheetModelTest, AnotherStatementDoesNotKeepTheDegreesOfFreedom) {
    type(0, Section::symbol, "l_S");
    type(0, Section::estimate, "1 mm");
    type(0, Section::stated, "U = 75 nm, k = 3, nu 18");
    type(0, Section::stated, "U = 80 nm, k = 3");
    EXPECT_EQ(text(0, Section::nu), QStringLiteral("18")) << "a figure was mended";
    type(0, Section::stated, "U = 30 nm, k = 2");
    EXPECT_EQ(stored(0, "nu"), SetupCell());
    type(0, Section::nu, "9");
    type(0, Section::stated, "rect 0.01 mm");
    EXPECT_EQ(stored(0, "nu"), SetupCell());
    type(0, Section::stated, "rect 0.01 mm, nu 12");
    EXPECT_EQ(text(0, Section::nu), QStringLiteral("12"));
}

TEST_F(BudgetSheetModelTest, UThatIsTypedKeepsTheFormOfTheStatement) {
    type(0, Section::symbol, "l_S");
    type(0, Section::estimate, "1 mm");
    type(0, Section::stated, "rect 0.1");
    type(1, Section::symbol, "d");
    type(1, Section::estimate, "1 mm");
    type(1, Section::stated, "U = 80 nm, k = 2");
    type(2, Section::symbol, "d");
    type(2, Section::unit, "mm");
    type(2, Section::stated, "5 nm");
    evaluate();
    ASSERT_TRUE(type(0, Section::u, "0.0367"));
    EXPECT_EQ(stored(0, "statement"), SetupCell(std::string("rectangular")));
    EXPECT_NEAR(std::get<double>(stored(0, "a")), 0.0367 * std::sqrt(3.0), 1e-12);
    ASSERT_TRUE(type(1, Section::u, "30 nm"));
    EXPECT_EQ(text(1, Section::stated), QStringLiteral("U = 60 nm, k = 2"));
    ASSERT_TRUE(type(2, Section::u, "7 nm"));
    EXPECT_EQ(text(2, Section::stated), QStringLiteral("u = 7 nm"));
    ASSERT_TRUE(type(2, Section::u, "rect 7 nm"));
    EXPECT_EQ(text(2, Section::stated), QString::fromUtf8("rectangular ± 7 nm"));
    EXPECT_FALSE(type(2, Section::u, ""));
    model->clear({model->index(0, Section::u)});
    EXPECT_EQ(stored(0, "statement"), SetupCell(std::string("rectangular"))) << "what follows is not cleared";
}

/// The figures stay with their row until they are computed anew.
TEST_F(BudgetSheetModelTest, WhatWasComputedGoesWithItsRow) {
    for (const auto& [row, symbol, u] : {std::tuple(0, "l_S", "25 nm"), {1, "d", "10 nm"}}) {
        type(row, Section::symbol, symbol);
        type(row, Section::estimate, "1 mm");
        type(row, Section::stated, u);
    }
    evaluate();
    const QString of_first = text(0, Section::u), of_second = text(1, Section::u);
    ASSERT_NE(of_first, of_second);
    ASSERT_TRUE(model->insertRow(1));
    model->set_result(shown, 0, false);
    EXPECT_EQ(text(0, Section::u), of_first);
    EXPECT_EQ(text(1, Section::u), QString());
    EXPECT_EQ(text(2, Section::u), of_second);
    ASSERT_TRUE(model->removeRow(0));
    model->set_result(shown, 0, false);
    EXPECT_EQ(text(0, Section::u), QString());
    EXPECT_EQ(text(1, Section::u), of_second);
}

/// The estimate of a quantity does not change with how its uncertainty is known.
TEST_F(BudgetSheetModelTest, ObservationsThatAreStatedOtherwiseLeaveTheirMean) {
    type(0, Section::symbol, "d");
    type(0, Section::unit, "nm");
    type(0, Section::stated, "210; 220; 215");
    type(0, Section::stated, "2 nm");
    EXPECT_EQ(stored(0, "value"), SetupCell(215.0));
    EXPECT_EQ(text(0, Section::stated), QStringLiteral("u = 2 nm"));
    type(0, Section::stated, "10.12; 10.15; 10.11; 10.14; 10.13");
    type(0, Section::stated, "2 nm");
    EXPECT_EQ(stored(0, "value"), SetupCell(10.13)) << "without the noise of a sum";
}

TEST_F(BudgetSheetModelTest, SmallFiguresAreShownAsPowersAndEditedAsTyped) {
    type(0, Section::symbol, "alpha");
    type(0, Section::estimate, "1.15e-5 1/K");
    type(0, Section::stated, "2e-6 1/K");
    EXPECT_EQ(text(0, Section::estimate), QStringLiteral("1.15×10⁻⁵"));
    EXPECT_EQ(model->index(0, Section::estimate).data(Qt::EditRole).toString(), QStringLiteral("1.15e-05"));
    EXPECT_EQ(text(0, Section::stated), QStringLiteral("u = 2×10⁻⁶ 1/K"));
    EXPECT_EQ(model->index(0, Section::stated).data(Qt::EditRole).toString(),
              QStringLiteral("u = 2e-06 1/K"));
}

TEST_F(BudgetSheetModelTest, WhatIsWrittenCanBeEdited) {
    type(0, Section::symbol, "x");
    type(0, Section::unit, "um");
    type(0, Section::stated, "rect 0.5");
    EXPECT_EQ(text(0, Section::stated), QString::fromUtf8("rectangular ± 0.5 µm"));
    ASSERT_TRUE(model->setData(model->index(0, Section::stated),
                               model->index(0, Section::stated).data(Qt::EditRole)));
    EXPECT_EQ(stored(0, "a"), SetupCell(0.5));
    type(0, Section::stated, "");
    EXPECT_EQ(stored(0, "statement"), SetupCell());
    EXPECT_EQ(stored(0, "a"), SetupCell());
}

TEST_F(BudgetSheetModelTest, WhatIsNotUnderstoodIsKeptAndSaidWhy) {
    type(0, Section::symbol, "x");
    type(0, Section::stated, "rect 0.5");
    type(0, Section::stated, "U 75");
    EXPECT_EQ(text(0, Section::stated), QStringLiteral("U 75"));
    EXPECT_TRUE(problem(0, Section::stated).contains(QStringLiteral("k = ")));
    EXPECT_EQ(stored(0, "statement"), SetupCell(std::string("rectangular"))) << "the project stays as it was";
    EXPECT_FALSE(document.unread().held(document.project()).analyses.empty()) << "and is not evaluated";
    type(0, Section::stated, "tri 0.5");
    EXPECT_TRUE(problem(0, Section::stated).isEmpty());
    type(0, Section::unit, "mm");
    type(0, Section::estimate, "3 kg");
    EXPECT_EQ(text(0, Section::estimate), QStringLiteral("3 kg"));
    EXPECT_FALSE(problem(0, Section::estimate).isEmpty());
    type(0, Section::estimate, "300 um");
    EXPECT_EQ(stored(0, "value"), SetupCell(0.3));
    type(0, Section::estimate, "1e400");
    EXPECT_FALSE(problem(0, Section::estimate).contains(QStringLiteral("unit"))) << "it is a number";
    EXPECT_FALSE(problem(0, Section::estimate).isEmpty());
}

// Copied out and pasted in again, computed cells and all: the same.
TEST_F(BudgetSheetModelTest, ABlockIsPastedAsOneStep) {
    EXPECT_EQ(model->paste(model->index(0, 0), QStringLiteral("a\tlength\t3\tmm\trect 20 um\n"
                                                              "b\twidth\t4\tmm\tu = 0.1 mm\n")),
              0);
    ASSERT_EQ(model->sheet().rowCount(), 2);
    EXPECT_EQ(stored(0, "a"), SetupCell(20.0));
    EXPECT_EQ(stored(1, "name"), SetupCell(std::string("width")));
    EXPECT_EQ(document.undo_stack().count(), 1);
    document.undo_stack().undo();
    EXPECT_EQ(model->sheet().rowCount(), 0);
}

TEST_F(BudgetSheetModelTest, ComputedCellsAreNotTyped) {
    type(0, Section::symbol, "x");
    for (int section = 0; section < BudgetSheetModel::sections; ++section)
        EXPECT_EQ(bool(model->flags(model->index(0, section)) & Qt::ItemIsEditable),
                  !BudgetSheetModel::is_computed(section) || section == Section::u);
    EXPECT_FALSE(type(0, Section::c, "3"));
}

/// The same figure means either, by the unit of its row.
TEST_F(BudgetSheetModelTest, AFigureInPercentSaysOfWhatItIs) {
    const auto help = [&](int row) {
        return model->index(row, Section::stated).data(Qt::ToolTipRole).toString();
    };
    type(0, Section::symbol, "l");
    type(0, Section::estimate, "5 mm");
    type(0, Section::stated, "U = 5 %, k = 2");
    EXPECT_TRUE(help(0).startsWith(QStringLiteral("5 % of the value\n"))) << to_std(help(0));
    type(1, Section::symbol, "r");
    type(1, Section::estimate, "0.4");
    type(1, Section::stated, "rect 5 %");
    EXPECT_TRUE(help(1).startsWith(QStringLiteral("5 % absolute"))) << to_std(help(1));
    type(2, Section::symbol, "h");
    type(2, Section::estimate, "40 %");
    type(2, Section::stated, "5");
    EXPECT_TRUE(help(2).startsWith(QStringLiteral("5 % absolute"))) << to_std(help(2));
    type(2, Section::stated, "limits 30 to 50");
    EXPECT_FALSE(help(2).contains(QStringLiteral("absolute, not"))) << "they are values";
    type(0, Section::stated, "5 um");
    EXPECT_FALSE(help(0).contains(QStringLiteral("5 % of"))) << to_std(help(0));
    type(1, Section::stated, "0.02");
    EXPECT_FALSE(help(1).contains(QStringLiteral("absolute, not"))) << "nobody takes it for a part";
}

/// All rows of the quantity are dimmed; the columns that say which quantity it is stay as they were.
TEST_F(BudgetSheetModelTest, WhatALinkReplacesIsShownAsNotUsed) {
    type(0, Section::symbol, "l_S");
    type(0, Section::estimate, "50 mm");
    type(0, Section::stated, "25 nm");
    type(1, Section::symbol, "d");
    type(1, Section::estimate, "215 nm");
    type(1, Section::stated, "5 nm");
    type(2, Section::symbol, "l_S");
    type(2, Section::unit, "mm");
    type(2, Section::stated, "rect 10 nm");
    const QColor dimmed = QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text);
    const auto is_dimmed = [&](int row, Section section) {
        return model->index(row, section).data(Qt::ForegroundRole).value<QColor>() == dimmed;
    };
    document.check_now();
    evaluate();
    EXPECT_FALSE(is_dimmed(0, Section::estimate));
    document.apply(QStringLiteral("link"), [](Project& project) {
        AnalysisEntry gauge = project.analyses[0];
        gauge.id = "gauge";
        gauge.name = "Gauge block";
        project.analyses.push_back(gauge);
        project.analyses[0].links = {{"l_S", {"gauge", "", "l"}}};
    });
    document.check_now();
    ASSERT_TRUE(document.maker().made()->analysis("budget"));
    for (const int row : {0, 2})
        for (const Section section : {Section::stated, Section::nu, Section::source}) {
            EXPECT_TRUE(is_dimmed(row, section)) << row << " " << section;
            EXPECT_TRUE(model->index(row, section)
                            .data(Qt::ToolTipRole)
                            .toString()
                            .contains(QStringLiteral("“Gauge block”")))
                << row << " " << section;
        }
    EXPECT_TRUE(is_dimmed(0, Section::estimate));
    EXPECT_FALSE(is_dimmed(0, Section::symbol) || is_dimmed(0, Section::unit));
    EXPECT_FALSE(is_dimmed(1, Section::estimate) || is_dimmed(1, Section::stated));
    EXPECT_TRUE(
        model->index(0, Section::u).data(Qt::ToolTipRole).toString().contains(QStringLiteral("l of")));
    EXPECT_EQ(text(0, Section::stated), QStringLiteral("u = 25 nm")) << "still readable";
    document.undo();
    document.check_now();
    EXPECT_FALSE(is_dimmed(0, Section::stated));
}

}  // namespace
}  // namespace covaria::ui::budget_sheet_model_test
