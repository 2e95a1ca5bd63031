// Marks the editors that are filled.
#include "ui/theme/steady_delegate.h"

#include <QVariant>
#include <QWidget>

namespace covaria::ui {

namespace {
constexpr const char* filled = "covaria_filled";
}

void SteadyDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    if (editor->property(filled).toBool()) return;
    editor->setProperty(filled, true);
    fill(editor, index);
}

void SteadyDelegate::fill(QWidget* editor, const QModelIndex& index) const {
    QStyledItemDelegate::setEditorData(editor, index);
}

}  // namespace covaria::ui
