#include "ui/main_window/pane_keys.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenu>

namespace covaria::ui {
namespace {

bool is_within(const QWidget& pane, const QWidget* widget) {
    return widget && (widget == &pane || pane.isAncestorOf(widget));
}

/// Whether a pane is not covered: all docks that are tabs of each other count as visible.
bool is_seen(const QWidget& pane) {
    const QWidget& window = *pane.window();
    return pane.isVisible() && is_within(pane, window.childAt(pane.mapTo(&window, pane.rect().center())));
}

bool takes_focus(const QWidget* widget) {
    return widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus);
}

}  // namespace

QWidget* place_for_keys(QWidget& pane) {
    if (QWidget* proxy = pane.focusProxy(); proxy && takes_focus(proxy)) return proxy;
    if (takes_focus(&pane)) return &pane;
    for (QWidget* next = pane.nextInFocusChain(); next != &pane; next = next->nextInFocusChain())
        if (is_within(pane, next) && takes_focus(next)) return next;
    return nullptr;
}

PaneKeys::PaneKeys(QMainWindow& window, std::function<QList<QWidget*>()> panes)
    : QObject(&window), panes_(std::move(panes)) {
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { remember(now); });
}

void PaneKeys::add_to(QMenu& menu) {
    menu.addAction(tr("Ne&xt Pane"), QKeySequence(Qt::Key_F6), this, [this] { go(1); });
    menu.addAction(tr("Pre&vious Pane"), QKeySequence(Qt::SHIFT | Qt::Key_F6), this, [this] { go(-1); });
}

void PaneKeys::remember(QWidget* focused) {
    for (QWidget* pane : panes_())
        if (focused && is_within(*pane, focused)) last_[pane] = focused;
}

/// The widget that had the focus last, else the pane's usual place for keys.
QWidget* PaneKeys::place_in(QWidget& pane) const {
    QWidget* last = last_.value(&pane);
    return last && is_within(pane, last) && takes_focus(last) ? last : place_for_keys(pane);
}

void PaneKeys::go(int direction) {
    QList<QWidget*> panes = panes_();
    panes.removeIf([this](QWidget* pane) { return !is_seen(*pane) || !place_in(*pane); });
    if (panes.isEmpty()) return;
    const QWidget* focused = QApplication::focusWidget();
    const auto now = std::find_if(panes.begin(), panes.end(),
                                  [&](const QWidget* pane) { return is_within(*pane, focused); });
    const auto count = panes.size();
    const auto at = now == panes.end() ? (direction > 0 ? count - 1 : 0) : now - panes.begin();
    place_in(*panes[(at + direction + count) % count])->setFocus(Qt::TabFocusReason);
}

}  // namespace covaria::ui
