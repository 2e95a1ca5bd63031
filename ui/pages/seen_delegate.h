// Cells of the table of stated against seen figures: the interval of a factor as a mark on a scale, the
// verdict as a word on a coloured ground.
#pragma once

#include "ui/theme/typeset_views.h"

namespace covaria::ui {

/// The scale of factors is logarithmic, from an eighth to eight; an end beyond it is an arrow.
class SeenDelegate : public TypesetDelegate {
public:
    using TypesetDelegate::TypesetDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace covaria::ui
