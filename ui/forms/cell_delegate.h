// Edits cells of tables: a list for choices, a line for everything else.
#pragma once

#include "ui/theme/typeset_views.h"

namespace covaria::ui {

class CellDelegate : public TypesetDelegate {
    Q_OBJECT
public:
    using TypesetDelegate::TypesetDelegate;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

protected:
    /// An editor in which nothing was typed leaves undo to the document.
    bool eventFilter(QObject* editor, QEvent* event) override;
    void fill(QWidget* editor, const QModelIndex& index) const override;
};

}  // namespace covaria::ui
