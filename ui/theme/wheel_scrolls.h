// The wheel over a page of fields scrolls the page; it changes no value on its way.
#pragma once

#include <QObject>

namespace covaria::ui {

/// Watches an application. Lists and number fields within something that scrolls leave the wheel to it, and
/// take the focus by a click or a key only.
class WheelScrolls : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace covaria::ui
