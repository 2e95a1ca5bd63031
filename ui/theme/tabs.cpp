#include "ui/theme/tabs.h"

#include <QMenu>
#include <QStyleOptionTab>
#include <QToolButton>
#include <algorithm>

namespace covaria::ui {

namespace {
constexpr int most_closer = 20;  // px taken from the style's padding of a tab, both sides together

}  // namespace

TabBar::TabBar(QWidget* parent) : QTabBar(parent), more_(new QToolButton(this)), menu_(new QMenu(this)) {
    more_->setObjectName(QStringLiteral("more_tabs"));
    more_->setText(QStringLiteral("»"));
    more_->setToolTip(tr("More tabs"));
    more_->setAccessibleName(tr("More tabs"));
    more_->setAutoRaise(true);
    more_->setFocusPolicy(Qt::NoFocus);
    more_->setPopupMode(QToolButton::InstantPopup);
    more_->setMenu(menu_);
    more_->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    more_->hide();
    setUsesScrollButtons(false);
    setElideMode(Qt::ElideNone);
    setExpanding(false);
    connect(menu_, &QMenu::aboutToShow, this, &TabBar::fill_menu);
    connect(this, &QTabBar::currentChanged, this, &TabBar::fit);
}

bool TabBar::is_in_menu(int index) const {
    return index >= 0 && index < int(in_menu_.size()) && in_menu_[std::size_t(index)];
}

int TabBar::closest_width() const {
    int width = 0;
    for (int i = 0; i < count(); ++i)
        if (isTabVisible(i)) width += QTabBar::tabSizeHint(i).width() + closer_ - most_closer;
    return width;
}

QSize TabBar::minimumSizeHint() const {
    return {4 * more_->sizeHint().width(), QTabBar::minimumSizeHint().height()};
}

QSize TabBar::tabSizeHint(int index) const {
    const QSize whole = QTabBar::tabSizeHint(index);
    return {is_in_menu(index) ? 0 : whole.width(), whole.height()};
}

void TabBar::initStyleOption(QStyleOptionTab* option, int index) const {
    QTabBar::initStyleOption(option, index);
    if (is_in_menu(index)) option->rect.moveRight(-1);  // outside: not drawn
}

void TabBar::tabLayoutChange() {
    QTabBar::tabLayoutChange();
    fit();
}

void TabBar::fit() {
    if (fitting_) return;
    fitting_ = true;
    std::vector<int> widths(std::size_t(count()), 0);
    int seen = 0;
    int wanted = 0;
    for (int i = 0; i < count(); ++i) {
        if (!isTabVisible(i)) continue;
        widths[std::size_t(i)] = QTabBar::tabSizeHint(i).width() + closer_;
        wanted += widths[std::size_t(i)];
        ++seen;
    }
    const int closer = seen > 0 ? std::clamp((wanted - width() + seen - 1) / seen, 0, most_closer) : 0;
    wanted -= closer * seen;
    for (int& of_tab : widths) of_tab = std::max(0, of_tab - closer);
    const bool all_fit = wanted <= width();
    std::vector<bool> in_menu(std::size_t(count()), false);
    const int room = width() - more_->sizeHint().width();
    for (int i = count() - 1; i >= 0 && !all_fit && wanted > room; --i) {
        if (!isTabVisible(i) || i == currentIndex()) continue;
        in_menu[std::size_t(i)] = true;
        wanted -= widths[std::size_t(i)];
    }
    const bool any = std::find(in_menu.begin(), in_menu.end(), true) != in_menu.end();
    if (closer != closer_ || in_menu != in_menu_) {
        closer_ = closer;
        in_menu_ = std::move(in_menu);
        setElideMode(Qt::ElideNone);  // lays the tabs out again
    }
    more_->setVisible(any);
    const QSize size = more_->sizeHint();
    more_->setGeometry(width() - size.width(), 0, size.width(), height());
    fitting_ = false;
}

void TabBar::fill_menu() {
    menu_->clear();
    for (int i = 0; i < count(); ++i)
        if (isTabVisible(i) && is_in_menu(i))
            menu_->addAction(tabText(i), this, [this, i] { setCurrentIndex(i); });
}

Tabs::Tabs(QWidget* parent) : QTabWidget(parent) {
    setTabBar(new TabBar);
    tabBar()->setFocusPolicy(Qt::StrongFocus);  // keys go on from the tab that was clicked
    setDocumentMode(true);
}

}  // namespace covaria::ui
