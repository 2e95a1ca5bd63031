#include "ui/models/interval_mark.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include "ui/theme/strings.h"

namespace covaria::ui {

QVariant interval_mark(int role) {
    if (role == Qt::ToolTipRole)
        return QObject::tr(
            "The interval is not symmetric about the estimate: state the interval, not y ± U (JCGM 101 "
            "5.5).");
    if (role == Qt::ForegroundRole)
        return QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text);
    if (role != Qt::FontRole) return {};
    QFont font;
    font.setItalic(true);
    return font;
}

}  // namespace covaria::ui
