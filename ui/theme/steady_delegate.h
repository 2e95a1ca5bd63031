// Delegate whose editors keep what is being typed.
#pragma once

#include <QStyledItemDelegate>

namespace covaria::ui {

/// Views fill an open editor anew whenever the data under it is said to have changed, which happens at any
/// moment: a run makes progress, a check ends. This one fills it once, when it opens.
class SteadyDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void setEditorData(QWidget* editor, const QModelIndex& index) const final;

protected:
    /// Called once for each editor.
    virtual void fill(QWidget* editor, const QModelIndex& index) const;
};

}  // namespace covaria::ui
