// Tabs that are all seen where they can be, and tabs that are there for some entries only.
#pragma once

#include <QTabBar>
#include <QTabWidget>
#include <vector>

class QMenu;
class QToolButton;

namespace covaria::ui {

/// Tabs stand closer where there is little room; where not all fit then, the last ones are in a menu at the
/// end of the bar. Names are whole. The current one is always seen. Keys go through all of them.
class TabBar : public QTabBar {
    Q_OBJECT
public:
    explicit TabBar(QWidget* parent = nullptr);

    /// Whether the tab is in the menu, because it has no room in the bar.
    bool is_in_menu(int index) const;
    /// px that a tab is narrower than the style has it.
    int closer() const { return closer_; }
    /// px in which all tabs can be seen.
    int closest_width() const;
    QToolButton& menu_button() { return *more_; }
    QSize minimumSizeHint() const override;

protected:
    QSize tabSizeHint(int index) const override;
    void initStyleOption(QStyleOptionTab* option, int index) const override;
    void tabLayoutChange() override;

private:
    void fit();
    void fill_menu();

    QToolButton* more_;
    QMenu* menu_;
    std::vector<bool> in_menu_;
    int closer_ = 0;
    bool fitting_ = false;
};

/// A tab widget with a TabBar, in Qt's document mode.
class Tabs : public QTabWidget {
    Q_OBJECT
public:
    explicit Tabs(QWidget* parent = nullptr);
};

/// The wheel and the arrow keys pass over what is disabled, not over what is hidden.
inline void show_tab(QTabWidget& tabs, QWidget* page, bool shown) {
    const int index = tabs.indexOf(page);
    tabs.setTabEnabled(index, shown);
    tabs.setTabVisible(index, shown);
}

}  // namespace covaria::ui
