// A page that needs less room than what is on it.
#pragma once

#include <QScrollArea>

namespace covaria::ui {

inline QScrollArea* scrolled(QWidget* content) {
    auto* area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setWidget(content);
    return area;
}

}  // namespace covaria::ui
