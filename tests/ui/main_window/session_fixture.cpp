// A user's hands and eyes.
#include "tests/ui/main_window/session_fixture.h"

#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QTimer>
#include <QToolButton>

#include "ui/theme/fold_groups.h"

namespace covaria::ui {

QString plain_words(QString words) {
    words.remove(QLatin1Char('&'));
    while (words.endsWith(QStringLiteral("…")) || words.endsWith(QLatin1Char(' '))) words.chop(1);
    return words;
}

QAction* Session::action(const QString& words) const {
    for (QAction* found : window_->findChildren<QAction*>())
        if (plain_words(found->text()) == words) return found;
    return nullptr;
}

void Session::trigger(const QString& words) {
    QAction* found = action(words);
    ASSERT_NE(found, nullptr) << words.toStdString();
    ASSERT_TRUE(found->isEnabled()) << words.toStdString();
    found->trigger();
}

QString Session::cell(const char* table, int row, int column) const {
    return sheet(table)->model()->index(row, column).data().toString();
}

void Session::type_into(const char* name, const QString& text) {
    auto* edit = field<QLineEdit>(name);
    ASSERT_NE(edit, nullptr);
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
}

void Session::choose_in(QComboBox& box, const QString& title) {
    const int wanted = box.findText(title);
    QStringList titles;
    for (int i = 0; i < box.count(); ++i) titles << box.itemText(i);
    ASSERT_GE(wanted, 0) << title.toStdString() << " is not among "
                         << titles.join(QStringLiteral(", ")).toStdString();
    box.setFocus();
    for (int steps = 0; box.currentText() != title && steps < 2 * box.count(); ++steps)
        QTest::keyClick(&box, box.findText(title) > box.currentIndex() ? Qt::Key_Down : Qt::Key_Up);
    ASSERT_EQ(box.currentText(), title);
}

void Session::choose(const char* name, const QString& title) {
    auto* box = field<QComboBox>(name);
    ASSERT_NE(box, nullptr);
    choose_in(*box, title);
}

void Session::show_group(const QString& title) {
    FoldGroups& groups = window_->properties().groups();
    for (int i = 0; i < groups.count(); ++i)
        if (groups.title(i) == title) {
            if (!groups.is_open(i)) QTest::mouseClick(groups.head(i), Qt::LeftButton);
            ASSERT_TRUE(groups.is_open(i));
            return;
        }
    FAIL() << "no group " << title.toStdString();
}

void Session::press_button(const char* table, const QString& words) {
    sheet(table)->setFocus();  // the tools of a table are there with the keyboard
    for (QAbstractButton* button : window_->properties().findChildren<QAbstractButton*>())
        if (button->isVisible() && plain_words(button->text()) == words) {
            QTest::mouseClick(button, Qt::LeftButton);
            return;
        }
    FAIL() << "no button " << words.toStdString();
}

void Session::press(const char* table, const QKeySequence& keys) {
    sheet(table)->setFocus();
    QTest::keySequence(sheet(table), keys);
}

void Session::go_to_cell(const char* table, int row, int column) {
    const QModelIndex index = sheet(table)->model()->index(row, column);
    if (!index.isValid()) return sheet(table)->setFocus();  // an empty table
    sheet(table)->scrollTo(index);
    QTest::mouseClick(sheet(table)->viewport(), Qt::LeftButton, {}, sheet(table)->visualRect(index).center());
    ASSERT_EQ(sheet(table)->currentIndex(), index);
}

void Session::paste(const char* table, int row, int column, const QString& text) {
    QGuiApplication::clipboard()->setText(text);
    go_to_cell(table, row, column);
    press(table, QKeySequence::Paste);
}

void Session::click_in_tree(const QString& name) {
    ProjectPane& tree = window_->project_pane();
    const QModelIndexList found = tree.model()->match(tree.model()->index(0, 0), Qt::DisplayRole, name, 1,
                                                      Qt::MatchExactly | Qt::MatchRecursive);
    ASSERT_EQ(found.size(), 1) << name.toStdString();
    tree.scrollTo(found[0]);
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualRect(found[0]).center());
}

QStringList Session::problems() {
    window_->document().check_now();
    const auto* pane = window_->findChild<ProblemsPane*>();
    QStringList words;
    for (int row = 0; row < pane->model()->rowCount(); ++row)
        for (int column = 0; column < ProblemsModel::remedy_column; ++column)
            words << pane->model()->index(row, column).data().toString();
    return words;
}

void Session::keep_picture(const QString& name) {
    settle();
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/%1.png").arg(name));
}

QImage Session::scene_picture() {
    EXPECT_TRUE(wait_for([this] { return !window_->scene().is_building(); }));
    window_->scene().view().service().wait_until_idle();
    QCoreApplication::processEvents();
    return window_->scene().view().image();
}

QStringList Session::names_in_tree() const {
    QStringList names;
    const QAbstractItemModel& tree = *window_->project_pane().model();
    for (int i = 0; i < tree.rowCount(); ++i) {
        const QModelIndex category = tree.index(i, 0);
        for (int row = 0; row < tree.rowCount(category); ++row)
            names << tree.index(row, 0, category).data().toString();
    }
    return names;
}

void type_key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
}

void type_keys(const QString& text) {
    for (const QChar c : text) QTest::keyClick(QApplication::focusWidget(), c.toLatin1());
}

void choose_from_context_menu(QWidget& widget, QPoint at, const QString& words) {
    bool chosen = false;
    QTimer watch;
    QObject::connect(&watch, &QTimer::timeout, &watch, [&] {
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        if (!menu) return;
        watch.stop();
        for (QAction* entry : menu->actions())
            if (plain_words(entry->text()) == words && entry->isEnabled()) {
                chosen = true;
                QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
                return;
            }
        menu->close();
    });
    watch.start(20);
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, widget.mapToGlobal(at));
    QApplication::sendEvent(&widget, &event);
    EXPECT_TRUE(chosen) << "no entry " << words.toStdString();
}

}  // namespace covaria::ui
