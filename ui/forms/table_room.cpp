#include "ui/forms/table_room.h"

#include <QEvent>
#include <QLayout>
#include <QScrollArea>
#include <QTimer>
#include <algorithm>

#include "ui/forms/spreadsheet_view.h"

namespace covaria::ui {

TableRoom::TableRoom(QScrollArea& area) : QObject(&area), area_(area) {
    area.viewport()->installEventFilter(this);
    area.widget()->installEventFilter(this);
}

bool TableRoom::eventFilter(QObject* watched, QEvent* event) {
    const bool other_room = watched == area_.viewport() && event->type() == QEvent::Resize;
    const bool other_page = watched == area_.widget() &&
                            (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show);
    if ((other_room || other_page) && !waits_) {
        waits_ = true;
        QTimer::singleShot(0, this, [this] {  // behind the layout of the page
            waits_ = false;
            share();
        });
    }
    return QObject::eventFilter(watched, event);
}

int TableRoom::height_of_others(const QList<SpreadsheetView*>& tables) const {
    QLayout& layout = *area_.widget()->layout();
    int height = layout.hasHeightForWidth() ? layout.totalHeightForWidth(area_.widget()->width())
                                            : layout.totalSizeHint().height();
    for (const SpreadsheetView* table : tables) height -= table->sizeHint().height();
    return height;
}

void TableRoom::share() {
    const QWidget* page = area_.widget();
    if (!page || !page->layout() || !page->isVisible()) return;
    QList<SpreadsheetView*> tables = page->findChildren<SpreadsheetView*>();
    tables.removeIf([page](const SpreadsheetView* table) { return !table->isVisibleTo(page); });
    if (tables.isEmpty()) return;
    const int room = area_.viewport()->height() - height_of_others(tables);
    const auto fits = [&](int rows) {
        int taken = 0;
        for (const SpreadsheetView* table : tables) taken += table->height_with(rows);
        return taken <= room;
    };
    int longest = 0;
    for (const SpreadsheetView* table : tables) longest = std::max(longest, table->model()->rowCount());
    int rows = SpreadsheetView::usual_rows;
    while (rows < longest && fits(rows + 1)) ++rows;
    for (SpreadsheetView* table : tables) table->set_most_rows(rows);
}

}  // namespace covaria::ui
