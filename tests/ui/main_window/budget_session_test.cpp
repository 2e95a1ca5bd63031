// The everyday budget, with the keyboard: a gauge block with five quantities and a correlation, from nothing
// to a PDF.
#include <QClipboard>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>
#include <QTabWidget>
#include <cmath>

#include "core/project/certificate.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/forms/budget_sheet_view.h"
#include "ui/main_window/export_actions.h"
#include "ui/models/budget_sheet_model.h"
#include "ui/pages/answer_strip.h"
#include "ui/pages/budget_page.h"
#include "ui/pages/evaluation_view.h"
#include "ui/theme/typeset_label.h"

namespace covaria::ui::budget_session_test {
namespace {

using Section = BudgetSheetModel::Section;

class BudgetSession : public Session {
protected:
    /// Counts an action of a user: a menu entry, a text typed and left, a cell typed, a move to another row.
    void count() { ++actions_; }

    void new_equation(const QString& text) {
        trigger(QStringLiteral("New Project"));
        count();
        trigger(QStringLiteral("Measurement equation"));
        count();
        auto* edit = field<QPlainTextEdit>("equations");
        edit->setFocus();
        ASSERT_TRUE(wait_for([&] { return edit->hasFocus(); }));
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Tab);
        count();
        ASSERT_TRUE(wait_for([&] { return sheet() != nullptr && sheet()->isVisible(); }));
    }
    BudgetSheetView* sheet() const { return window_->budget().view(); }
    /// Types into a cell in place of its text, and goes on by Tab.
    void type_cell(int row, Section section, const QString& text) {
        sheet()->setFocus();
        const QModelIndex cell = window_->budget().model()->index(row, section);
        sheet()->selectionModel()->setCurrentIndex(cell, QItemSelectionModel::ClearAndSelect);
        QTest::keyClick(sheet(), Qt::Key_F2);
        QWidget* line = QApplication::focusWidget();
        ASSERT_NE(line, sheet());
        QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(line, text);
        QTest::keyClick(line, Qt::Key_Tab);
        count();
    }
    /// The keys begin in the row behind them.
    void correlate_last_rows(const QString& coefficient) {
        type_key(Qt::Key_Up);
        count();
        type_key(Qt::Key_Up, Qt::ShiftModifier);
        count();
        QLineEdit& r = window_->budget().correlation();
        ASSERT_TRUE(wait_for([&] { return r.isEnabled(); }));
        type_key(Qt::Key_R, Qt::ControlModifier);
        count();
        ASSERT_TRUE(wait_for([&] { return r.hasFocus() && r.hasSelectedText(); }, 2000) ||
                    r.text().isEmpty());
        type_keys(coefficient);
        type_key(Qt::Key_Return);
        count();
    }
    QString cell(int row, Section section) const {
        return window_->budget().model()->index(row, section).data().toString();
    }
    int row_of(const QString& symbol) const {
        for (int row = 0; row < window_->budget().model()->rowCount(); ++row)
            if (window_->budget().model()->index(row, Section::symbol).data(Qt::EditRole) == symbol)
                return row;
        ADD_FAILURE() << symbol.toStdString() << " has no row";
        return 0;
    }
    void keep_picture(const QString& name) {
        QDir folder(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
        folder.mkpath(QStringLiteral("."));
        window_->grab().save(folder.filePath(name));
    }
    int actions_ = 0;
};

// Five quantities and a correlation, by keys alone; every command, every cell typed and every move is
// counted.
TEST_F(BudgetSession, GaugeBlockFromNothingToPdfInTwentyActions) {
    trigger(QStringLiteral("New Project"));
    count();
    QApplication::setActiveWindow(window_.get());
    type_key(Qt::Key_Return);  // the first of what can be evaluated
    count();
    auto* equations = field<QPlainTextEdit>("equations");
    ASSERT_TRUE(wait_for([&] { return equations->hasFocus(); }));
    type_keys(QStringLiteral("l = l_S + d + l_S*alpha_S*(theta_S - theta)"));
    type_key(Qt::Key_Tab);
    count();
    ASSERT_EQ(window_->budget().model()->sheet().rowCount(), 5) << "rows come with the names";
    EXPECT_EQ(equations->toPlainText(), QStringLiteral("l = l_S + d + l_S*alpha_S*(theta_S - theta)"));
    const struct {
        const char *symbol, *estimate, *stated;
    } rows[] = {{"l_S", "50.000623 mm", "25 nm nu 18"},
                {"d", "215 nm", "9.7 nm nu 25"},
                {"alpha_S", "11.5e-6 1/K", "rect 2e-6"},
                {"theta_S", "0.02 K", "0.05 K"},
                {"theta", "-0.01 K", "0.05 K"}};
    for (const auto& row : rows) {
        EXPECT_EQ(row_of(QLatin1String(row.symbol)), sheet()->currentIndex().row());
        EXPECT_EQ(sheet()->currentIndex().column(), Section::estimate);
        type_keys(QLatin1String(row.estimate));
        type_key(Qt::Key_Tab);
        count();
        type_keys(QLatin1String(row.stated));
        type_key(Qt::Key_Return);
        QApplication::processEvents();  // the editor is left in its own time
        count();
    }
    EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
    ASSERT_TRUE(wait_for([&] { return status().result && status().is_of_present(); }));
    ASSERT_TRUE(wait_for([&] { return !cell(0, Section::share).isEmpty(); }));
    ASSERT_NO_FATAL_FAILURE(correlate_last_rows(QStringLiteral("0.9")));
    // u^2 = (25 nm)^2 + (9.7 nm)^2 + (l alpha)^2 2 (1 - r) (0.05 K)^2 + (l 0.03 K 2e-6/K / sqrt 3)^2
    const double thermal = 50.000623e6 * 11.5e-6, expansion = 50.000623e6 * 0.03 * 2e-6 / std::sqrt(3.0);
    const double u =
        std::sqrt(25.0 * 25.0 + 9.7 * 9.7 + thermal * thermal * 0.2 * 0.0025 + expansion * expansion);
    EXPECT_TRUE(wait_for([&] {
        return status().is_of_present() &&
               std::abs(status().result->outputs[0].first_order.standard_uncertainty - u * 1e-9) <
                   1e-4 * u * 1e-9;
    })) << status().result->outputs[0].first_order.standard_uncertainty;
    const AnswerStrip& answer = window_->results().answer();
    EXPECT_TRUE(answer.isVisible());
    EXPECT_TRUE(answer.statements().contains(QString::fromUtf8("±"))) << answer.statements().toStdString();
    EXPECT_EQ(answer.value().text().letters().find("l = ("), 0U) << answer.value().text().letters();
    EXPECT_TRUE(answer.coverage().text().letters().starts_with("k = ")) << answer.coverage().text().letters();
    EXPECT_TRUE(window_->budget().remark().text().contains(QString::fromUtf8("\u00a0=\u00a00.9")))
        << "the correlation is said, too";
    settle();
    keep_picture(QStringLiteral("budget.png"));
    const QString pdf = folder_.filePath(QStringLiteral("gauge.pdf"));
    answer_.file_to_save = pdf;
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    window_->exports().pdf_action->trigger();  // Ctrl+P; what it needs is run
    count();
    count();  // the name of the file, and Return
    ASSERT_TRUE(wait_for([&] { return !finished.empty(); }, 120'000));
    EXPECT_TRUE(status().is_current());
    EXPECT_GT(QFileInfo(pdf).size(), 10'000);
    EXPECT_LE(actions_, 20);
}

// Eight quantities, a correlation and all texts that ISO/IEC 17025 asks for, by keys, menus and one name.
TEST_F(BudgetSession, GaugeBlockFromNothingToItsCertificateInFortyActions) {
    window_->files().dialogs.confirm = [](const QString&, const QString&) { return false; };
    trigger(QStringLiteral("New Project"));
    count();
    QApplication::setActiveWindow(window_.get());
    type_key(Qt::Key_Return);  // the first of what can be evaluated
    count();
    auto* equations = field<QPlainTextEdit>("equations");
    ASSERT_TRUE(wait_for([&] { return equations->hasFocus(); }));
    type_keys(QStringLiteral("l = l_S + d + c - l_N*(alpha*delta_t + delta_alpha*Delta_t)"));
    type_key(Qt::Key_Tab);
    count();
    ASSERT_EQ(window_->budget().model()->sheet().rowCount(), 8) << "rows come with the names";
    const struct {
        const char *symbol, *estimate, *stated;
    } rows[] = {{"l_S", "50.000020(15) mm", nullptr}, {"d", "-96.4(13) nm", nullptr},
                {"c", "0 nm", "rect 32 nm"},          {"l_N", "50 mm", "constant"},
                {"alpha", "11.5e-6 1/K", "tri 1e-6"}, {"delta_t", "0.02 K", "rect 0.05"},
                {"delta_alpha", "0 1/K", "tri 2e-6"}, {"Delta_t", "0.30 K", "rect 0.5"}};
    for (const auto& row : rows) {
        EXPECT_EQ(row_of(QLatin1String(row.symbol)), sheet()->currentIndex().row());
        ASSERT_EQ(sheet()->currentIndex().column(), Section::estimate) << row.symbol;
        type_keys(QString::fromUtf8(row.estimate));
        type_key(row.stated ? Qt::Key_Tab : Qt::Key_Return);
        count();
        if (row.stated) {
            type_keys(QLatin1String(row.stated));
            type_key(Qt::Key_Return);
            count();
        }
        QApplication::processEvents();  // the editor is left in its own time
    }
    EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
    ASSERT_TRUE(wait_for([&] { return status().result && status().is_of_present(); }));
    ASSERT_NO_FATAL_FAILURE(correlate_last_rows(QStringLiteral("0.3")));
    go_to_cell("outputs", 0, 1);
    count();
    type_keys(QStringLiteral("length at 20 C"));
    type_key(Qt::Key_Return);
    count();
    trigger(QStringLiteral("Certificate as PDF"));  // says what is missing, and goes there
    count();
    count();  // Escape in its question
    std::size_t texts = 0;
    for (const CertificateField& one : certificate_fields()) texts += one.required;
    for (std::size_t i = 0; i < texts; ++i) {
        type_key(Qt::Key_Return, Qt::ControlModifier);  // to the next that is missing
        const CertificateField* of = nullptr;
        for (const CertificateField& one : certificate_fields()) {
            auto* editor = window_->properties().findChild<QWidget*>(to_qt(pointer_of(one)));
            const QWidget* focus = QApplication::focusWidget();
            if (editor && (editor == focus || editor->isAncestorOf(focus))) of = &one;
        }
        ASSERT_NE(of, nullptr) << i;
        const bool is_date = of->kind == CertificateText::date || of->kind == CertificateText::dates;
        type_keys(is_date ? QStringLiteral("2026-11-26") : QString::fromLatin1(of->title));
        count();
        QApplication::processEvents();
    }
    type_key(Qt::Key_Return, Qt::ControlModifier);
    for (const CertificateField& one : certificate_fields()) {
        if (!one.required) continue;
        EXPECT_FALSE((window_->document().project().certificate.*one.member).empty()) << one.title;
    }
    const QString pdf = folder_.filePath(QStringLiteral("certificate.pdf"));
    answer_.file_to_save = pdf;
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    trigger(QStringLiteral("Certificate as PDF"));
    count();
    count();  // the name of the file, and Return
    ASSERT_TRUE(wait_for([&] { return !finished.empty(); }, 120'000));
    EXPECT_GT(QFileInfo(pdf).size(), 10'000);
    RecordProperty("actions", actions_);
    EXPECT_LE(actions_, 40);
}

// Tab goes over what is typed and passes what is computed; a name in the last row is a new quantity.
TEST_F(BudgetSession, TheKeyboardGoesOverTheSheet) {
    new_equation(QStringLiteral("y = a"));
    sheet()->setFocus();
    sheet()->selectionModel()->setCurrentIndex(window_->budget().model()->index(0, Section::stated),
                                               QItemSelectionModel::ClearAndSelect);
    QTest::keyClick(sheet(), Qt::Key_Tab);
    EXPECT_EQ(sheet()->currentIndex().column(), Section::nu);
    QTest::keyClick(sheet(), Qt::Key_Tab);
    EXPECT_EQ(sheet()->currentIndex().column(), Section::source);
    QTest::keyClick(sheet(), Qt::Key_Tab);
    EXPECT_EQ(sheet()->currentIndex().row(), 1);
    EXPECT_EQ(sheet()->currentIndex().column(), Section::symbol);
    type_keys(QStringLiteral("b"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_TRUE(wait_for([&] { return window_->budget().model()->sheet().rowCount() == 2; }, 2000));
    EXPECT_EQ(cell(1, Section::symbol), QStringLiteral("b"));
}

TEST_F(BudgetSession, WhatIsTypedIntoTheLastRowIsOneQuantity) {
    new_equation(QStringLiteral("y = a"));
    const int rows = window_->budget().model()->sheet().rowCount();
    sheet()->setFocus();
    sheet()->selectionModel()->setCurrentIndex(window_->budget().model()->index(rows, Section::symbol),
                                               QItemSelectionModel::ClearAndSelect);
    for (const char* text : {"d", "deviation", "0", "um", "75 nm"}) {
        type_keys(QString::fromLatin1(text));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QTest::qWait(30);
    }
    EXPECT_EQ(window_->budget().model()->sheet().rowCount(), rows + 1);
    EXPECT_EQ(cell(rows, Section::symbol), QStringLiteral("d"));
    EXPECT_EQ(cell(rows, Section::name), QStringLiteral("deviation"));
    EXPECT_EQ(cell(rows, Section::stated), QStringLiteral("u = 75 nm"));
}

/// "50 mm" fills the unit, too: what is typed next is the statement.
TEST_F(BudgetSession, TabPassesOverAUnitThatCameWithTheEstimate) {
    new_equation(QStringLiteral("y = a"));
    sheet()->setFocus();
    sheet()->selectionModel()->setCurrentIndex(window_->budget().model()->index(0, Section::estimate),
                                               QItemSelectionModel::ClearAndSelect);
    type_keys(QStringLiteral("50 mm"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    EXPECT_EQ(sheet()->currentIndex().column(), Section::stated);
    type_keys(QStringLiteral("75 nm"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_TRUE(wait_for([&] { return cell(0, Section::stated) == QStringLiteral("u = 75 nm"); }, 2000))
        << to_std(cell(0, Section::stated));
    EXPECT_EQ(cell(0, Section::unit), QStringLiteral("mm"));
}

/// A unit typed into its own cell is found behind the estimate, as in any spreadsheet.
TEST_F(BudgetSession, TabStopsAtAUnitThatStoodBefore) {
    new_equation(QStringLiteral("y = a"));
    type_cell(0, Section::estimate, QStringLiteral("50 mm"));
    type_cell(0, Section::estimate, QStringLiteral("60"));
    EXPECT_EQ(sheet()->currentIndex().column(), Section::unit);
    EXPECT_EQ(cell(0, Section::unit), QStringLiteral("mm"));
}

TEST_F(BudgetSession, DigitsOfUAreThoseOfItsComponentsToo) {
    new_equation(QStringLiteral("y = a"));
    type_cell(0, Section::estimate, QStringLiteral("50 mm"));
    type_cell(0, Section::stated, QStringLiteral("U = 1 um, p = 95 %"));
    const auto shows = [&](Section section, const char* number) {
        return wait_for([&] { return cell(0, section).remove(QChar(0x202f)) == QLatin1String(number); },
                        2000);
    };
    EXPECT_TRUE(shows(Section::u, "0.00051")) << cell(0, Section::u).toStdString();
    window_->results().digits().setValue(4);
    EXPECT_TRUE(shows(Section::u, "0.0005102")) << cell(0, Section::u).toStdString();
    EXPECT_TRUE(shows(Section::contribution, "510.2")) << cell(0, Section::contribution).toStdString();
    window_->document().apply(QStringLiteral("Units"),
                              [](Project& project) { project.results.style.units.choose(Unit::of("um")); });
    EXPECT_EQ(window_->results().digits().value(), 4) << "a unit changes no digits";
    EXPECT_TRUE(shows(Section::contribution, "510.2")) << cell(0, Section::contribution).toStdString();
}

/// The same symbols, and infinite degrees of freedom as they are shown.
TEST_F(BudgetSession, WhatIsCopiedIsPastedBackAsItWas) {
    new_equation(QStringLiteral("V_out = V_in*R_2"));
    for (const int row : {0, 1}) {
        type_cell(row, Section::estimate, QStringLiteral("10"));
        type_cell(row, Section::stated, QStringLiteral("U = 0.4, k = 2"));
    }
    ASSERT_TRUE(wait_for([&] { return !cell(1, Section::u).isEmpty() && status().is_of_present(); }));
    const auto before = window_->document().project().analyses;
    sheet()->setFocus();
    QTest::keyClick(sheet(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(sheet(), Qt::Key_C, Qt::ControlModifier);
    EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("\nV_in\t")))
        << QGuiApplication::clipboard()->text().toStdString();
    sheet()->setCurrentIndex(window_->budget().model()->index(0, 0));
    QTest::keyClick(sheet(), Qt::Key_V, Qt::ControlModifier);
    EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
    EXPECT_EQ(window_->document().project().analyses, before);
}

/// u follows from the statement: typing there changes that.
TEST_F(BudgetSession, TypingOnUStatesTheUncertainty) {
    new_equation(QStringLiteral("y = a"));
    sheet()->setFocus();
    const auto go = [&](Section section) {
        sheet()->selectionModel()->setCurrentIndex(window_->budget().model()->index(0, section),
                                                   QItemSelectionModel::ClearAndSelect);
    };
    go(Section::estimate);
    type_keys(QStringLiteral("50 mm"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    go(Section::u);
    type_keys(QStringLiteral("75 nm"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_TRUE(wait_for([&] { return cell(0, Section::stated) == QStringLiteral("u = 75 nm"); }, 2000))
        << to_std(cell(0, Section::stated));
    go(Section::distribution);
    type_keys(QStringLiteral("rect 30 nm"));
    EXPECT_EQ(sheet()->currentIndex().column(), Section::stated) << "what follows from it is edited there";
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_TRUE(wait_for([&] { return cell(0, Section::stated).startsWith(QStringLiteral("rect")); }, 2000));
}

// The centre belongs to the analysis: equations have a budget, scenes have none over them.
TEST_F(BudgetSession, IsThereForEquationsOnly) {
    open(project_copy());
    ASSERT_TRUE(wait_for([&] { return status().prepared != nullptr; }));
    EXPECT_EQ(sheet(), nullptr);
    EXPECT_TRUE(window_->budget().isHidden());
    const QString file = folder_.filePath(QStringLiteral("h1.covaria"));
    ASSERT_TRUE(QFile::copy(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria"), file));
    open(file);
    ASSERT_TRUE(wait_for([&] { return sheet() && sheet()->isVisible(); }));
    ASSERT_TRUE(wait_for([&] { return !cell(0, Section::share).isEmpty(); }));
    settle();
    keep_picture(QStringLiteral("budget-h1.png"));
}

// Words give way, the sources too: the last number, the index, is in view whole.
TEST_F(BudgetSession, NoNumberIsCutWhileWordsCouldBe) {
    const QString file = folder_.filePath(QStringLiteral("s1.covaria"));
    ASSERT_TRUE(
        QFile::copy(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/s1-9.5-gauge-block.covaria"), file));
    window_->resize(1920, 1080);
    open(file);
    ASSERT_TRUE(wait_for([&] { return sheet() && sheet()->isVisible(); }));
    ASSERT_TRUE(wait_for([&] { return !cell(0, Section::share).isEmpty(); }));
    settle();
    const auto hidden = [&] { return sheet()->horizontalHeader()->length() - sheet()->viewport()->width(); };
    EXPECT_TRUE(wait_for([&] { return hidden() <= 0; }, 3000)) << hidden() << " px are out of view";
    for (int row = 0; row < 9; ++row)
        for (const Section section : {Section::estimate, Section::u, Section::c, Section::share})
            EXPECT_GE(sheet()->columnWidth(section),
                      sheet()->sizeHintForIndex(window_->budget().model()->index(row, section)).width())
                << row << ' ' << int(section);
    for (const Section section : {Section::name, Section::stated, Section::source})
        EXPECT_GE(sheet()->columnWidth(section), 110) << "words are told apart";
    keep_picture(QStringLiteral("budget-s1-wide.png"));
    window_->resize(1280, 800);
    settle();
    EXPECT_TRUE(sheet()->isColumnHidden(Section::source)) << "the source is the first to go";
    EXPECT_GE(sheet()->columnWidth(Section::name), 110) << "words are told apart";
}

TEST_F(BudgetSession, AllColumnsOfTheGaugeBlockAreInViewAt1440) {
    const QString file = folder_.filePath(QStringLiteral("block.covaria"));
    ASSERT_TRUE(
        QFile::copy(QStringLiteral(COVARIA_SOURCE_DIR "/projects/certificate-gauge-block.covaria"), file));
    window_->resize(1440, 900);
    open(file);
    ASSERT_TRUE(wait_for([&] { return sheet() && sheet()->isVisible(); }));
    ASSERT_TRUE(wait_for([&] { return !cell(0, Section::share).isEmpty(); }));
    trigger(QStringLiteral("Reset Layout"));
    settle();
    for (int section = 0; section < window_->budget().model()->columnCount(); ++section)
        EXPECT_FALSE(sheet()->isColumnHidden(section)) << section;
    const auto hidden = [&] { return sheet()->horizontalHeader()->length() - sheet()->viewport()->width(); };
    EXPECT_TRUE(wait_for([&] { return hidden() <= 0; }, 3000)) << hidden() << " px are out of view";
    // Terms of a sum have c = 1, whatever their prefix.
    EXPECT_EQ(cell(row_of(QStringLiteral("d")), Section::c), QStringLiteral("1.00"));
    keep_picture(QStringLiteral("budget-block-1440.png"));
}

// While it is typed an equation is not wrong.
TEST_F(BudgetSession, AnEquationWithoutItsEndIsIncomplete) {
    trigger(QStringLiteral("New Project"));
    trigger(QStringLiteral("Measurement equation"));
    auto* edit = field<QPlainTextEdit>("equations");
    const auto is_called = [&](const QString& text, RunState state) {
        edit->setPlainText(text);
        return wait_for([&] { return !window_->document().maker().is_making() && status().state == state; },
                        5000);
    };
    EXPECT_TRUE(is_called(QStringLiteral("y ="), RunState::incomplete));
    EXPECT_EQ(window_->results().answer().next_step().text(), QStringLiteral("Next: Equations"));
    EXPECT_TRUE(is_called(QStringLiteral("y = a) + b"), RunState::failed));
    EXPECT_TRUE(is_called(QString::fromUtf8("φ = 2*a\ny = φ + sqrt(b"), RunState::incomplete));
    EXPECT_TRUE(is_called(QStringLiteral("y = a b"), RunState::failed));
    EXPECT_TRUE(is_called(QStringLiteral("y = a *\n"), RunState::incomplete));
    EXPECT_TRUE(is_called(QStringLiteral("y = a * b_2"), RunState::incomplete)) << "names get their rows";
}

// A refused text that is undone leaves no wide column; the window says what was undone.
TEST_F(BudgetSession, ARefusedTextThatIsUndoneGivesItsRoomBack) {
    new_equation(QStringLiteral("y = a*b"));
    type_cell(row_of(QStringLiteral("a")), Section::estimate, QStringLiteral("10 V"));
    settle();
    const int before = sheet()->columnWidth(Section::estimate);
    const QString wrong = QStringLiteral("what nobody would ever call an estimate of it");
    type_cell(row_of(QStringLiteral("b")), Section::estimate, wrong);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);  // the cell that Tab went on to
    ASSERT_GT(sheet()->columnWidth(Section::estimate), before + 60);
    type_key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(wait_for([&] { return sheet()->columnWidth(Section::estimate) == before; }, 3000))
        << sheet()->columnWidth(Section::estimate) << " px, " << before << " before";
    type_key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window_->statusBar()->currentMessage(),
              QStringLiteral("Undone: Change Quantities: a, estimate"))
        << window_->statusBar()->currentMessage().toStdString();
}

// A row of the budget leads to the facts about its quantity: by a double click on a computed cell, and by
// the keyboard.
TEST_F(BudgetSession, AQuantityHasAPageOfItsOwn) {
    const QString file = folder_.filePath(QStringLiteral("h2.covaria"));
    ASSERT_TRUE(QFile::copy(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/h2-impedance.covaria"), file));
    open(file);
    ASSERT_TRUE(wait_for([&] { return sheet() && sheet()->isVisible() && !cell(0, Section::u).isEmpty(); }));
    const QModelIndex computed = window_->budget().model()->index(row_of(QStringLiteral("V")), Section::c);
    sheet()->setCurrentIndex(computed);
    const QPoint at = sheet()->visualRect(computed).center();
    QTest::mouseClick(sheet()->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(sheet()->viewport(), Qt::LeftButton, {}, at);
    auto* notes = window_->properties().findChild<QPlainTextEdit*>(QStringLiteral("quantity_notes"));
    ASSERT_NE(notes, nullptr);
    const FoldGroups* details = nullptr;
    for (const QWidget* around = notes->parentWidget(); around && !details; around = around->parentWidget())
        details = qobject_cast<const FoldGroups*>(around);
    ASSERT_NE(details, nullptr);
    ASSERT_TRUE(wait_for([&] { return details->isVisible(); }));
    EXPECT_EQ(details->count(), 4);
    auto* observed = qobject_cast<EvaluationView*>(details->page(1));
    ASSERT_NE(observed, nullptr);
    EXPECT_TRUE(wait_for([&] { return observed->isVisible(); }));
    EXPECT_EQ(observed->chart().plot().quantity, "V");
    EXPECT_EQ(observed->chart().plot().series.front().y.size(), 5u);
    settle();
    keep_picture(QStringLiteral("quantity-observations.png"));
    FoldGroups::reveal(*notes);
    notes->setFocus();
    QTest::keyClicks(notes, QStringLiteral("five readings"));
    const auto& kept = [&]() -> const std::vector<QuantityNotes>& {
        return window_->document().project().analyses.front().quantity_notes;
    };
    ASSERT_EQ(kept().size(), 1u);
    EXPECT_EQ(kept().front(), (QuantityNotes{"V", "five readings"}));
    EXPECT_TRUE(wait_for([&] { return status().is_of_present(); })) << "no result is out of date";
    window_->document().undo_stack().undo();
    EXPECT_TRUE(kept().empty());
    EXPECT_TRUE(notes->toPlainText().isEmpty());
    sheet()->setFocus();
    sheet()->selectionModel()->setCurrentIndex(
        window_->budget().model()->index(row_of(QStringLiteral("I")), Section::estimate),
        QItemSelectionModel::ClearAndSelect);
    QTest::keyClick(sheet(), Qt::Key_Return, Qt::AltModifier);
    EXPECT_TRUE(wait_for([&] { return observed->chart().plot().quantity == "I"; }));
}

}  // namespace
}  // namespace covaria::ui::budget_session_test
