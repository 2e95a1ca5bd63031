#include "ui/theme/style.h"

#include <QApplication>
#include <QPalette>
#include <QStyleOption>

#include "ui/theme/theme.h"

namespace covaria::ui {

Style::Style() : QProxyStyle(QStringLiteral("Fusion")) {
    setObjectName(QStringLiteral("covaria"));
}

int Style::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                     QStyleHintReturn* data) const {
    if (hint != SH_Table_GridLineColor) return QProxyStyle::styleHint(hint, option, widget, data);
    const QPalette palette = option ? option->palette : QApplication::palette();
    return int(mix(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.16).rgb());
}

}  // namespace covaria::ui
