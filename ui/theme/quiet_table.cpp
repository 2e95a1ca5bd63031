#include "ui/theme/quiet_table.h"

#include <QHeaderView>
#include <QTableView>

#include "ui/theme/follow_font.h"

namespace covaria::ui {

void make_quiet(QTableView& view, RowRoom room) {
    view.setShowGrid(false);
    view.setFrameShape(QFrame::NoFrame);
    follow_font(view, [&view, room] {
        const int height = view.fontMetrics().height() + static_cast<int>(room);
        if (view.verticalHeader()->defaultSectionSize() != height)
            view.verticalHeader()->setDefaultSectionSize(height);
    });
}

}  // namespace covaria::ui
