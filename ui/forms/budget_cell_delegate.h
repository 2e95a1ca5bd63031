// Cells of a budget: the share with a bar, the distribution as a sketch of its density.
#pragma once

#include "ui/forms/cell_delegate.h"

namespace covaria::ui {

/// A bar is as long as the share is of the largest one, in the colour of its type of evaluation. The word of
/// a distribution that has a sketch stands in its tooltip, and is what is copied and read aloud.
class BudgetCellDelegate : public CellDelegate {
public:
    using CellDelegate::CellDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace covaria::ui
