// A page that needs less room than what is on it; its tables share what it has to spare.
#pragma once

#include <QScrollArea>

#include "ui/forms/table_room.h"

namespace covaria::ui {

inline QScrollArea* scrolled(QWidget* content) {
    auto* area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setWidget(content);
    new TableRoom(*area);
    return area;
}

}  // namespace covaria::ui
