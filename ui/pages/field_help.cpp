#include "ui/pages/field_help.h"

#include <QApplication>

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
    setFixedHeight(lines_shown * fontMetrics().lineSpacing() + 12);
    setForegroundRole(QPalette::WindowText);
    setText(tr("Numbers may be typed with another unit (0.5 um); the arrow keys change the last digit."));
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { show_help_of(now); });
}

void FieldHelp::show_help_of(const QWidget* widget) {
    if (!widget || !area_.isAncestorOf(widget) || widget->toolTip().isEmpty()) return;
    const QString name = widget->accessibleName().toHtmlEscaped();
    const QString help =
        widget->toolTip().toHtmlEscaped().replace(QStringLiteral("\n\n"), QStringLiteral(" "));
    setText(name.isEmpty() ? help : QStringLiteral("<b>%1.</b> %2").arg(name, help));
    setToolTip(widget->toolTip());
}

}  // namespace covaria::ui
