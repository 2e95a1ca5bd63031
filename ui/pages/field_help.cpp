#include "ui/pages/field_help.h"

#include <QApplication>
#include <QEvent>
#include <QRegularExpression>

#include "ui/forms/complaint.h"
#include "ui/models/number_words.h"
#include "ui/theme/follow_font.h"

namespace covaria::ui {
namespace {
constexpr int lines_shown = 3;
}

FieldHelp::FieldHelp(QWidget& area) : QLabel(&area), area_(area) {
    setAccessibleName(tr("Help on the field"));
    setWordWrap(true);
    setTextFormat(Qt::RichText);
    setAlignment(Qt::AlignTop);
    setMargin(6);
    follow_font(*this, [this] { setFixedHeight(lines_shown * fontMetrics().lineSpacing() + 12); });
    setForegroundRole(QPalette::WindowText);
    start_over();
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
}

void FieldHelp::start_over(bool has_numbers) {
    if (shown_) shown_->removeEventFilter(this);
    shown_ = nullptr;
    setText(has_numbers
                ? tr("Numbers may be typed with another unit (%1); the arrow keys change the last digit.")
                      .arg(localized("0.5") + QStringLiteral("\u00a0µm"))
                : QString());
    setToolTip({});
}

void FieldHelp::follow(QWidget* widget) {
    if (!widget || widget == shown_ || !area_.isAncestorOf(widget) || widget->toolTip().isEmpty()) return;
    if (shown_) shown_->removeEventFilter(this);
    shown_ = widget;
    shown_->installEventFilter(this);
    show_help();
}

bool FieldHelp::eventFilter(QObject* watched, QEvent* event) {
    if (watched == shown_ && event->type() == QEvent::ToolTipChange) show_help();
    return QLabel::eventFilter(watched, event);
}

void FieldHelp::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    if (shown_) show_help();
}

void FieldHelp::show_help() {
    const QString name = shown_->accessibleName();
    const QString head = name.isEmpty() ? QString() : name + QStringLiteral(". ");
    static const QRegularExpression open_end(QStringLiteral("(?<=[^.:!?…\\s])\\s*\n\n"));
    const QString all = head + shown_->toolTip()
                                   .replace(open_end, QStringLiteral(". "))
                                   .replace(QStringLiteral("\n\n"), QStringLiteral(" "));
    const QString fitting = what_fits(*this, all);
    setText(QStringLiteral("<b>%1</b>%2")
                .arg(fitting.left(head.size()).toHtmlEscaped(), fitting.mid(head.size()).toHtmlEscaped()));
    setToolTip(shown_->toolTip());
}

}  // namespace covaria::ui
