// Font changes are events of the widget.
#include "ui/theme/follow_font.h"

#include <QEvent>
#include <QHeaderView>
#include <QTableView>

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

void rows_follow_font(QTableView& view) {
    follow_font(view, [&view] {
        const int height = view.fontMetrics().height() + 8;
        if (view.verticalHeader()->defaultSectionSize() != height)
            view.verticalHeader()->setDefaultSectionSize(height);
    });
}

}  // namespace covaria::ui
