#include "ui/pages/highlight_frame.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QEvent>
#include <QPainter>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabWidget>

#include "ui/theme/fold_groups.h"

namespace covaria::ui {
namespace {

constexpr int outside = 4;  // distance from the target, where there is room
constexpr double line = 3.0;

template <class Pages>
void show_page_of(Pages& pages, const QWidget& widget) {
    for (int page = 0; page < pages.count(); ++page)
        if (pages.widget(page)->isAncestorOf(&widget)) pages.setCurrentIndex(page);
}

/// The part of a widget that the widgets around it leave, in its window.
QRect seen_part(const QWidget& widget) {
    QRect seen(widget.mapTo(widget.window(), QPoint()), widget.size());
    for (const QWidget* around = widget.parentWidget(); around && !around->isWindow();
         around = around->parentWidget())
        seen &= QRect(around->mapTo(around->window(), QPoint()), around->size());
    return seen;
}

}  // namespace

HighlightFrame::HighlightFrame(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("highlight_frame"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void HighlightFrame::surround(QWidget* target) {
    for (const QPointer<QWidget>& one : watched_)
        if (one) one->removeEventFilter(this);
    watched_.clear();
    target_ = target;
    for (QWidget* one = target; one; one = one->isWindow() ? nullptr : one->parentWidget()) {
        one->installEventFilter(this);
        watched_ << one;
    }
    if (target && parentWidget() != target->window()) setParent(target->window());
    follow();
}

void HighlightFrame::follow() {
    const QRect seen = target_ && target_->isVisible() ? seen_part(*target_) : QRect();
    setVisible(!seen.isEmpty());
    if (seen.isEmpty()) return;
    setGeometry(seen.adjusted(-outside, -outside, outside, outside) & parentWidget()->rect());
    raise();
}

bool HighlightFrame::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
        case QEvent::Move:
        case QEvent::Resize:
        case QEvent::Show:
        case QEvent::Hide:
        case QEvent::LayoutRequest:
            // Queued: until all parts of the change have happened.
            QMetaObject::invokeMethod(this, &HighlightFrame::follow, Qt::QueuedConnection);
            break;
        default:
            break;
    }
    return false;
}

void HighlightFrame::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Highlight), line));
    painter.drawRoundedRect(QRectF(rect()).adjusted(line / 2, line / 2, -line / 2, -line / 2), outside,
                            outside);
}

bool reveal(QWidget& widget) {
    FoldGroups::reveal(widget);
    for (QWidget* around = &widget; around; around = around->parentWidget()) {
        if (auto* tabs = qobject_cast<QTabWidget*>(around)) {
            show_page_of(*tabs, widget);
        } else if (auto* pages = qobject_cast<QStackedWidget*>(around)) {
            if (!qobject_cast<QTabWidget*>(pages->parentWidget())) show_page_of(*pages, widget);
        } else if (auto* dock = qobject_cast<QDockWidget*>(around)) {
            dock->show();
            dock->raise();
        }
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // places are those of now
    for (QWidget* around = widget.parentWidget(); around; around = around->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(around)) area->ensureWidgetVisible(&widget);
    return widget.isVisible();
}

}  // namespace covaria::ui
