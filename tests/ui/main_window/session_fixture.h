// The actions of a user on the window: menus, keys, clicks, and looking at what is there.
#pragma once

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QPushButton>
#include <QTabWidget>
#include <functional>

#include "tests/ui/main_window/window_fixture.h"
#include "ui/forms/spreadsheet_view.h"
#include "ui/pages/message_panes.h"
#include "ui/pages/project_pane.h"
#include "ui/pages/properties_pane.h"
#include "ui/pages/results_pane.h"
#include "ui/scene_view/scene_panel.h"
#include "ui/theme/fold_groups.h"

namespace covaria::ui {

class Session : public WindowFixture {
protected:
    /// The entry of a menu with these words (without mnemonics and dots); null when there is none.
    QAction* action(const QString& words) const;
    /// Chooses it; a disabled or missing entry fails the test.
    void trigger(const QString& words);

    /// The first field of the properties with this name, in whichever group, which is opened for it; fails
    /// the test when a user would not see it.
    template <class Widget = QWidget>
    Widget* field(const char* name) const {
        auto* found = window_->properties().findChild<Widget*>(QString::fromLatin1(name));
        if (found) FoldGroups::reveal(*found);
        EXPECT_NE(found, nullptr) << name;
        EXPECT_TRUE(found && wait_for([&] { return found->isVisible(); }, 2000)) << name << " is not shown";
        return found;
    }
    SpreadsheetView* sheet(const char* name) const { return field<SpreadsheetView>(name); }
    QString cell(const char* table, int row, int column) const;
    /// Types into a field and presses Enter.
    void type_into(const char* name, const QString& text);
    /// Goes through a list by the arrow keys to the entry with this title.
    void choose(const char* name, const QString& title);
    static void choose_in(QComboBox& box, const QString& title);
    /// Shows a group of the properties; opens it by a click on its head where it is folded.
    void show_group(const QString& title);
    /// Presses a button of the form of a table.
    void press_button(const char* table, const QString& words);
    void press(const char* table, const QKeySequence& keys);
    void go_to_cell(const char* table, int row, int column);
    /// Through the clipboard, at a cell (or into an empty table).
    void paste(const char* table, int row, int column, const QString& text);

    void select(SetupOwner owner, const std::string& id) { window_->selection().select_entry({owner, id}); }
    /// Selects an entry by a click on its name in the tree.
    void click_in_tree(const QString& name);
    const AnalysisStatus& status() const { return window_->runner().status(window_->selection().analysis()); }
    double expanded_uncertainty(std::size_t output) const {
        return status().result->outputs[output].expanded_uncertainty;
    }
    bool wait_for(const std::function<bool()>& condition, int milliseconds = 30'000) const {
        return QTest::qWaitFor(condition, milliseconds);
    }
    /// The words of all problems listed (kind, place, problem), once the list is that of the present project.
    QStringList problems();
    /// Keeps a picture of the settled window for people to look at: screenshots/NAME.png.
    void keep_picture(const QString& name);
    /// Waits for the scene of the present results, then its picture.
    QImage scene_picture();
    QStringList names_in_tree() const;
};

/// Types to whatever has the focus, as a keyboard does.
void type_keys(const QString& text);
void type_key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
/// Chooses an entry of the context menu that `widget` opens at `at`.
void choose_from_context_menu(QWidget& widget, QPoint at, const QString& words);
/// An entry's words without mnemonics and trailing dots.
QString plain_words(QString words);

}  // namespace covaria::ui
