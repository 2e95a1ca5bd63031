// Font changes are events of the widget.
#include "ui/theme/follow_font.h"

#include <QEvent>
#include <QWidget>

namespace covaria::ui {
namespace {

class FontFollower : public QObject {
public:
    FontFollower(QWidget& widget, std::function<void()> size) : QObject(&widget), size_(std::move(size)) {
        widget.installEventFilter(this);
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::FontChange) size_();
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<void()> size_;
};

}  // namespace

void follow_font(QWidget& widget, std::function<void()> size) {
    size();
    new FontFollower(widget, std::move(size));  // the widget's own
}

}  // namespace covaria::ui
