// Editors of cells.
#include "ui/forms/cell_delegate.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <algorithm>

#include "ui/models/roles.h"

namespace covaria::ui {

namespace {

/// Tells a choice by the keyboard, which may go on, from one by the mouse, which is final.
class ChoiceBox : public QComboBox {
public:
    using QComboBox::QComboBox;
    bool is_in_key_press() const { return in_key_press_; }

protected:
    void keyPressEvent(QKeyEvent* event) override {
        in_key_press_ = true;
        QComboBox::keyPressEvent(event);
        in_key_press_ = false;
    }

private:
    bool in_key_press_ = false;
};

/// Widens the line over cells to its right, as far as there are any: typed text stays in view.
void grow(QLineEdit& line) {
    const int wanted = line.fontMetrics().horizontalAdvance(line.text()) + 2 * line.fontMetrics().height();
    const int room = line.parentWidget()->width() - line.x();
    if (wanted > line.width()) line.resize(std::max(line.width(), std::min(wanted, room)), line.height());
}

}  // namespace

QWidget* CellDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                    const QModelIndex& index) const {
    const QStringList choices = index.data(choices_role).toStringList();
    if (choices.isEmpty()) {
        auto* line = new QLineEdit(parent);
        line->setFrame(false);
        line->setAlignment(static_cast<Qt::Alignment>(index.data(Qt::TextAlignmentRole).toInt()));
        connect(line, &QLineEdit::textChanged, line, [line] { grow(*line); });
        return line;
    }
    auto* box = new ChoiceBox(parent);
    box->addItems(choices);
    connect(box, &QComboBox::activated, this, [this, box] {
        if (box->is_in_key_press()) return;  // goes on to the next choice; Enter or Tab takes it
        auto* self = const_cast<CellDelegate*>(this);
        emit self->commitData(box);
        emit self->closeEditor(box);
    });
    return box;
}

void CellDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                        const QModelIndex& index) const {
    TypesetDelegate::updateEditorGeometry(editor, option, index);
    if (auto* line = qobject_cast<QLineEdit*>(editor)) grow(*line);
}

void CellDelegate::fill(QWidget* editor, const QModelIndex& index) const {
    const QString text = index.data(Qt::EditRole).toString();
    if (auto* box = qobject_cast<QComboBox*>(editor))
        box->setCurrentText(text);
    else if (auto* line = qobject_cast<QLineEdit*>(editor))
        line->setText(text);
}

bool CellDelegate::eventFilter(QObject* editor, QEvent* event) {
    auto* line = qobject_cast<QLineEdit*>(editor);
    const bool is_undo = event->type() == QEvent::ShortcutOverride &&
                         static_cast<QKeyEvent*>(event)->matches(QKeySequence::Undo);
    if (!line || !is_undo || line->isUndoAvailable()) return TypesetDelegate::eventFilter(editor, event);
    emit closeEditor(line, RevertModelCache);
    event->ignore();
    return true;
}

void CellDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
    QString text;
    if (const auto* box = qobject_cast<QComboBox*>(editor)) text = box->currentText();
    if (const auto* line = qobject_cast<QLineEdit*>(editor)) text = line->text();
    if (text != index.data(Qt::EditRole).toString()) model->setData(index, text, Qt::EditRole);
}

}  // namespace covaria::ui
