// Rows of the project tree and of the problems list with their pictures: kind of entry, state, severity.
#pragma once

#include <QStyledItemDelegate>

#include "ui/run/run_state.h"

namespace covaria::ui {

/// Name of the icon of a state: shape and colour both tell it.
QString state_icon(RunState state);

class EntryDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace covaria::ui
