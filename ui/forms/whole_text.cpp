#include "ui/forms/whole_text.h"

#include <QComboBox>
#include <QEvent>
#include <QLayout>
#include <QLineEdit>
#include <QPointer>
#include <QScrollArea>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QStyleOptionFrame>
#include <functional>

namespace covaria::ui {
namespace {

class WholeText : public QObject {
public:
    WholeText(QWidget& editor, std::function<int()> wanted)
        : QObject(&editor), editor_(editor), wanted_(std::move(wanted)), least_(editor.minimumWidth()) {
        editor_.installEventFilter(this);
    }
    void fit() {
        if (!page_) return;
        constexpr int air = 6;  // the space around a text
        int wanted = std::min(wanted_(), room());
        const int beside = wanted - over_the_edge(wanted);
        if (beside < wanted && wanted - beside <= air) wanted = beside;
        editor_.setMinimumWidth(std::max(least_, wanted));
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == &editor_ && event->type() == QEvent::Show) find_page();
        if (watched == &editor_ && (event->type() == QEvent::FontChange || event->type() == QEvent::Move))
            fit();
        if (watched == page_ && event->type() == QEvent::Resize) fit();
        return QObject::eventFilter(watched, event);
    }

private:
    void find_page() {
        for (QWidget* around = editor_.parentWidget(); around && !page_; around = around->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(around)) {
                page_ = area->viewport();
                page_->installEventFilter(this);
            }
        fit();
    }
    /// Sum of the margins of frames and layouts around it, up to the page.
    QMargins margins_around() const {
        QMargins sum;
        for (const QWidget* around = editor_.parentWidget(); around != page_;
             around = around->parentWidget()) {
            sum += around->contentsMargins();  // the frame of a group
            if (const QLayout* layout = around->layout()) sum += layout->contentsMargins();
        }
        return sum;
    }
    /// Length by which it would reach beyond the page from its present place.
    int over_the_edge(int width) const {
        const int right = page_->width() - margins_around().right();
        return std::max(0, editor_.mapTo(page_.data(), QPoint()).x() + width - right);
    }
    int room() const {
        const QMargins around = margins_around();
        // Forms count it in rows too whose field stands below its label.
        return page_->width() - around.left() - around.right() -
               editor_.style()->pixelMetric(QStyle::PM_LayoutHorizontalSpacing, nullptr, &editor_);
    }

    QWidget& editor_;
    std::function<int()> wanted_;
    int least_;
    QPointer<QWidget> page_;
};

}  // namespace

void keep_whole(QComboBox& box) {
    auto* whole = new WholeText(box, [&box] {
        QStyleOptionComboBox option;
        option.initFrom(&box);
        const QSize text(box.fontMetrics().horizontalAdvance(box.currentText()) + 6,
                         box.fontMetrics().height());
        return box.style()->sizeFromContents(QStyle::CT_ComboBox, &option, text, &box).width();
    });
    QObject::connect(&box, &QComboBox::currentTextChanged, whole, &WholeText::fit);
}

void keep_whole(QLineEdit& line) {
    auto* whole = new WholeText(line, [&line] {
        QStyleOptionFrame option;
        option.initFrom(&line);
        option.lineWidth = line.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &line);
        const QString shown = line.text().isEmpty() ? line.placeholderText() : line.text();
        const QSize text(line.fontMetrics().horizontalAdvance(shown) + 8, line.fontMetrics().height());
        return line.style()->sizeFromContents(QStyle::CT_LineEdit, &option, text, &line).width();
    });
    QObject::connect(&line, &QLineEdit::editingFinished, whole, &WholeText::fit);
    QObject::connect(&line, &QLineEdit::textChanged, whole, [whole, &line] {
        if (!line.hasFocus()) whole->fit();
    });
}

}  // namespace covaria::ui
