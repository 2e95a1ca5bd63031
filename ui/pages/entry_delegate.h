// Rows of the project tree and of the problems list with their pictures: kind of entry, state, severity.
#pragma once

#include "ui/run/run_state.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {

/// Name of the icon of a state: shape and colour both tell it.
QString state_icon(RunState state);

class EntryDelegate : public TypesetDelegate {
public:
    using TypesetDelegate::TypesetDelegate;
    enum class Level { project, category, entry };
    static Level level_of(const QModelIndex& index);
    /// Names and messages are words, not symbols: they are drawn as they are.
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace covaria::ui
