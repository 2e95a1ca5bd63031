#include "ui/forms/read_only_hint.h"

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QToolTip>

namespace covaria::ui {
namespace {

bool is_typed(const QEvent& event) {
    if (event.type() != QEvent::KeyPress) return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    const bool is_letter = !key.text().isEmpty() && key.text().front().isPrint();
    return key.key() == Qt::Key_F2 ||
           (is_letter && !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier)));
}

}  // namespace

ReadOnlyHint::ReadOnlyHint(QAbstractItemView& view, std::function<QString()> reason)
    : QObject(&view), view_(view), reason_(std::move(reason)) {
    view.installEventFilter(this);
    view.viewport()->installEventFilter(this);
}

bool ReadOnlyHint::eventFilter(QObject* watched, QEvent* event) {
    const bool is_key = is_typed(*event);
    if (!is_key && event->type() != QEvent::MouseButtonDblClick) return QObject::eventFilter(watched, event);
    const QModelIndex cell = view_.currentIndex();
    const QString reason = reason_();
    if (reason.isEmpty() || !cell.isValid() || cell.flags().testFlag(Qt::ItemIsEditable))
        return QObject::eventFilter(watched, event);
    QToolTip::showText(view_.viewport()->mapToGlobal(view_.visualRect(cell).bottomLeft()), reason, &view_);
    return is_key;
}

}  // namespace covaria::ui
