// A form made from a schema with a field of every kind, driven by keys and clicks.
#include "ui/forms/setup_form.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include "tests/ui/qt_application.h"
#include "tests/ui/sample_schema.h"
#include "ui/forms/complaint.h"
#include "ui/forms/quantity_edit.h"
#include "ui/forms/table_editor.h"
#include "ui/forms/table_room.h"
#include "ui/theme/fold_groups.h"

namespace covaria::ui::setup_form_test {
namespace {

struct SetupFormTest : testing::Test {
    SetupFormTest() {
        document.replace(sample_project());
        form = std::make_unique<SetupForm>(document, sample_address(), &sample_schema());
        for (auto* groups : form->findChildren<FoldGroups*>())
            for (int group = 0; group < groups->count(); ++group) groups->open(group);
        form->resize(600, 900);
        form->show();
        QApplication::setActiveWindow(form.get());
        EXPECT_TRUE(QTest::qWaitForWindowActive(form.get()));
    }
    template <class Widget>
    Widget* find(const char* name) {
        auto* widget = form->findChild<Widget*>(name);
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    const covaria::Setup& setup() const { return document.project().assets[0].setup; }
    void type(const char* field, const QString& text) {
        auto* edit = find<QLineEdit>(field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    void choose(const char* field, Qt::Key key) {
        auto* box = find<QComboBox>(field);
        box->setFocus();
        QTest::keyClick(box, key);
    }
    Problems found;
    Document document{[this](const MadeProject&) { return found; }, nullptr};
    std::unique_ptr<SetupForm> form;
};

TEST_F(SetupFormTest, HasAnEditorForEveryFieldWithNameAndHelp) {
    for (const FieldSpec& field : sample_schema().fields()) {
        ASSERT_NE(form->editor(field.key), nullptr) << field.key;
        auto* widget = form->editor(field.key)->focusProxy();
        ASSERT_NE(widget, nullptr) << field.key;
        EXPECT_TRUE(widget->accessibleName().startsWith(QString::fromStdString(field.title)));
        EXPECT_TRUE(widget->toolTip().startsWith(QString::fromStdString(field.help))) << field.key;
    }
    EXPECT_EQ(form->editor("nothing"), nullptr);
    EXPECT_EQ(find<QLineEdit>("length")->text(), "100 mm") << "the default";
}

TEST_F(SetupFormTest, NoFieldOfAPoseIsCutByWhatItStandsIn) {
    for (const int width : {600, 380, 300}) {
        form->resize(width, 900);
        QApplication::processEvents();
        for (int part = 0; part < 6; ++part) {
            const auto* edit = find<QLineEdit>(("pose_" + std::to_string(part)).c_str());
            for (const QWidget *inner = edit, *outer = edit->parentWidget(); outer != form.get();
                 inner = outer, outer = outer->parentWidget()) {
                if (qobject_cast<const QAbstractScrollArea*>(outer->parentWidget())) break;
                EXPECT_GE(inner->x(), 0) << width << ", " << part;
                EXPECT_LE(inner->geometry().right(), outer->rect().right()) << width << ", " << part;
            }
        }
    }
}

TEST_F(SetupFormTest, NumbersAreWrittenAsTyped) {
    type("length", "0.5 um");
    EXPECT_EQ(setup().values.at("length"), SetupValue(Quantity{0.5, Unit::of("um")}));
    type("count", "4");
    EXPECT_EQ(setup().values.at("count"), SetupValue(Quantity{4.0, Unit()}));
    type("count", "4.5");
    EXPECT_EQ(setup().values.at("count"), SetupValue(Quantity{4.0, Unit()}));
    EXPECT_EQ(document.undo_stack().count(), 2);
    document.undo_stack().undo();
    document.undo_stack().undo();
    EXPECT_EQ(document.project(), sample_project());
    EXPECT_EQ(find<QLineEdit>("length")->text(), "100 mm");
}

TEST_F(SetupFormTest, ChoicesShowAndHideWhatDependsOnThem) {
    auto* depth = find<QLineEdit>("depth");
    EXPECT_FALSE(depth->isVisible());
    choose("mode", Qt::Key_Down);
    EXPECT_EQ(setup().values.at("mode"), SetupValue(std::string("full")));
    EXPECT_TRUE(depth->isVisible());
    bool heading = false;
    for (auto* head : form->findChildren<FoldHead*>())
        heading |= head->text() == "Details" && head->isVisible();
    EXPECT_TRUE(heading);
    document.undo_stack().undo();
    EXPECT_FALSE(depth->isVisible());
}

TEST_F(SetupFormTest, AFieldOfAFoldedSectionIsShownByWhoLeadsToIt) {
    auto* view = find<SpreadsheetView>("points");
    auto* groups = form->findChild<FoldGroups*>();
    ASSERT_NE(groups, nullptr);
    for (int group = 0; group < groups->count(); ++group)
        if (FoldHead* head = groups->head(group)) head->setChecked(false);
    EXPECT_FALSE(view->isVisible());
    EXPECT_TRUE(form->focus_field("/assets/0/setup/points/rows/1/u_x"));
    EXPECT_TRUE(view->isVisible());
    EXPECT_EQ(QApplication::focusWidget(), view);
}

TEST_F(SetupFormTest, TheToolsOfATableAreThereWithTheKeyboard) {
    auto* view = find<SpreadsheetView>("points");
    QToolButton* add = nullptr;
    for (auto* button : form->findChildren<QToolButton*>())
        if (button->accessibleName() == "Add row") add = button;
    ASSERT_NE(add, nullptr);
    find<QLineEdit>("length")->setFocus();
    EXPECT_FALSE(add->isVisible());
    view->setFocus();
    EXPECT_TRUE(add->isVisible());
    const int rows = view->model()->rowCount();
    QTest::mouseClick(add, Qt::LeftButton);
    EXPECT_EQ(view->model()->rowCount(), rows + 1);
    EXPECT_TRUE(view->hasFocus()) << "what comes next is typed";
}

TEST_F(SetupFormTest, FlagsAndTextsAreEditedAndTypingMerges) {
    QTest::mouseClick(find<QCheckBox>("exact"), Qt::LeftButton, {},
                      QPoint(8, find<QCheckBox>("exact")->height() / 2));
    EXPECT_EQ(setup().values.at("exact"), SetupValue(true));
    auto* label = find<QLineEdit>("label");
    QTest::keyClicks(label, "abc");
    EXPECT_EQ(setup().values.at("label"), SetupValue(std::string("abc")));
    EXPECT_EQ(document.undo_stack().count(), 2);
    for (int i = 0; i < 3; ++i) QTest::keyClick(label, Qt::Key_Backspace);
    EXPECT_FALSE(setup().values.contains("label")) << "an empty text is no value";
}

TEST_F(SetupFormTest, PosesAreEditedPartByPart) {
    type("pose_1", "2 cm");
    type("pose_5", "90");
    const auto& pose = std::get<PoseValue>(setup().values.at("pose"));
    EXPECT_EQ(pose.position[1], 20.0) << "in the pose's unit";
    EXPECT_EQ(pose.angles[2], 90.0);
}

// Numbers of every length, in the narrowest form: the whole text has room, its sign first of all.
TEST_F(SetupFormTest, NoPartOfAPoseIsOutOfSight) {
    form->resize(form->minimumSizeHint().width(), 900);
    for (const char* number : {"-1.5", "-987.6281", "-9887.628", "-98876.62812", "-0.00001234567"}) {
        for (int part = 0; part < 6; ++part)
            type(("pose_" + std::to_string(part)).c_str(), QString::fromLatin1(number));
        form->setFocus();
        QTest::qWait(10);
        for (int part = 0; part < 6; ++part) {
            const auto* edit = find<QLineEdit>(("pose_" + std::to_string(part)).c_str());
            EXPECT_GT(edit->width(), edit->fontMetrics().horizontalAdvance(edit->text())) << number;
            EXPECT_EQ(edit->cursorPosition(), 0) << number;
        }
    }
}

TEST_F(SetupFormTest, AReferenceWithNothingThatFitsSaysSo) {
    EXPECT_TRUE(find<QComboBox>("source")->currentText().contains("add it first"));
}

TEST_F(SetupFormTest, ProblemsStandAtTheirFields) {
    found.error("/assets/0/setup/length", "longer than the robot");
    found.error("/assets/0/setup/points/rows/1/2", "too large");
    document.check_now();
    EXPECT_EQ(complaint_of(*find<QLineEdit>("length")), "longer than the robot");
    EXPECT_TRUE(complaint_of(*find<QLineEdit>("count")).isEmpty());
    EXPECT_EQ(complaint_of(*find<SpreadsheetView>("points")), "too large");
    found = {};
    document.check_now();
    EXPECT_TRUE(complaint_of(*find<QLineEdit>("length")).isEmpty());
}

TEST_F(SetupFormTest, AProblemLeadsToItsField) {
    EXPECT_TRUE(form->focus_field("/assets/0/setup/length"));
    EXPECT_EQ(QApplication::focusWidget(), find<QLineEdit>("length"));
    EXPECT_TRUE(form->focus_field("/assets/0/setup/points/rows/1/u_x"));
    auto* view = find<SpreadsheetView>("points");
    EXPECT_EQ(QApplication::focusWidget(), view);
    EXPECT_EQ(view->currentIndex(), view->model()->index(1, 2));
    EXPECT_TRUE(form->focus_field("/pose/angles/1"));
    EXPECT_EQ(QApplication::focusWidget(), find<QLineEdit>("pose_4"));
    EXPECT_FALSE(form->focus_field("/title"));
}

TEST_F(SetupFormTest, TheSpreadsheetIsUsedWithTheKeyboard) {
    auto* view = find<SpreadsheetView>("points");
    view->setFocus();
    view->setCurrentIndex(view->model()->index(0, 1));
    QTest::keyClicks(view, "4");
    QWidget* cell = QApplication::focusWidget();
    ASSERT_NE(qobject_cast<QLineEdit*>(cell), nullptr);
    QTest::keyClicks(cell, "2 cm");
    QTest::keyClick(cell, Qt::Key_Return);
    QCoreApplication::processEvents();  // the delegate commits when the key has been dealt with
    EXPECT_EQ(view->model()->index(0, 1).data().toString(), "420");
    EXPECT_EQ(view->currentIndex().row(), 1) << "Enter goes down";
    QTest::keyClick(view, Qt::Key_Return);
    EXPECT_EQ(view->currentIndex().row(), 2);

    view->selectAll();
    QTest::keyClick(view, Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(view->model()->index(2, 1).data().toString(), "420");
    view->selectionModel()->setCurrentIndex(view->model()->index(2, 0), QItemSelectionModel::ClearAndSelect);
    QTest::keyClick(view, Qt::Key_Minus, Qt::ControlModifier);
    EXPECT_EQ(view->model()->rowCount(), 2);
    QTest::keyClick(view, Qt::Key_I, Qt::ControlModifier);
    EXPECT_EQ(view->model()->rowCount(), 3);
    // Return below the last row begins another, which stays one while it is empty.
    view->selectionModel()->setCurrentIndex(view->model()->index(2, 1), QItemSelectionModel::ClearAndSelect);
    QTest::keyClick(view, Qt::Key_Return);
    EXPECT_EQ(view->model()->rowCount(), 4);
    EXPECT_EQ(view->currentIndex(), view->model()->index(3, 1));
    QTest::keyClick(view, Qt::Key_Return);
    EXPECT_EQ(view->model()->rowCount(), 4);
    while (document.undo_stack().canUndo()) document.undo_stack().undo();
    EXPECT_EQ(document.project(), sample_project());
}

TEST_F(SetupFormTest, AColumnIsAsWideAsWhatIsTypedIntoIt) {
    auto* view = find<SpreadsheetView>("points");
    view->setFocus();
    const auto type = [view](const QString& text) {
        view->setCurrentIndex(view->model()->index(0, 1));
        QTest::keyClicks(view, text.left(1));
        QWidget* cell = QApplication::focusWidget();
        ASSERT_NE(qobject_cast<QLineEdit*>(cell), nullptr);
        QTest::keyClicks(cell, text.mid(1));
        QTest::keyClick(cell, Qt::Key_Return);
        QCoreApplication::processEvents();
    };
    type(QStringLiteral("4"));
    const int before = view->columnWidth(1);
    type(QStringLiteral("123456.789012345"));
    EXPECT_GT(view->columnWidth(1), before);
    type(QStringLiteral("4"));
    EXPECT_EQ(view->columnWidth(1), before);
    type(QStringLiteral("123456.789012345"));
    view->setColumnWidth(1, 300);  // the user's own width
    type(QStringLiteral("4"));
    EXPECT_EQ(view->columnWidth(1), 300);
}

TEST_F(SetupFormTest, ALongTableTakesTheRoomThatItsPageHasToSpare) {
    auto* view = find<SpreadsheetView>("points");
    while (view->model()->rowCount() < 22) view->append_row_action()->trigger();
    QScrollArea area;
    area.setWidgetResizable(true);
    area.setWidget(form.get());
    new TableRoom(area);
    area.resize(600, 500);
    area.show();
    const auto rows_in_view = [view] {
        return (view->viewport()->height() + 1) / view->verticalHeader()->defaultSectionSize();
    };
    EXPECT_TRUE(QTest::qWaitFor([&] { return rows_in_view() == SpreadsheetView::usual_rows; }, 2000))
        << rows_in_view();
    area.resize(600, 1800);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view->verticalScrollBar()->maximum() == 0; }, 2000))
        << rows_in_view() << " rows of 22";
    EXPECT_EQ(area.verticalScrollBar()->maximum(), 0);
    const int row = view->verticalHeader()->defaultSectionSize();
    for (int height = 1800; rows_in_view() >= 22 && height > 500; height -= row) {
        area.resize(600, height);
        QTest::qWait(50);
    }
    EXPECT_GT(rows_in_view(), SpreadsheetView::usual_rows) << "as many as there is room for";
    EXPECT_TRUE(QTest::qWaitFor([&] { return area.verticalScrollBar()->maximum() == 0; }, 2000))
        << "the page does not scroll for them";
    area.takeWidget();
}

TEST_F(SetupFormTest, BlocksAreCopiedAndPasted) {
    auto* view = find<SpreadsheetView>("points");
    view->setFocus();
    view->setCurrentIndex(view->model()->index(1, 1));
    QApplication::clipboard()->setText("7\t8\n9\tnonsense\n11\t12\n");
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(view->model()->rowCount(), 4);
    EXPECT_EQ(view->model()->index(3, 2).data().toString(), "12");
    EXPECT_EQ(view->model()->index(2, 2).data().toString(), "nonsense");
    view->selectRow(1);
    QTest::keyClick(view, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QApplication::clipboard()->text(), "b2\t7\t8\tNest\n");
    QTest::keyClick(view, Qt::Key_Delete);
    EXPECT_EQ(view->model()->index(1, 1).data().toString(), "");
}

TEST_F(SetupFormTest, TheFormIsOffWhenItsEntryIsGone) {
    document.apply("Delete", [](Project& project) { project.assets.clear(); });
    EXPECT_FALSE(form->isEnabled());
    document.undo_stack().undo();
    EXPECT_TRUE(form->isEnabled());
}

}  // namespace
}  // namespace covaria::ui::setup_form_test
