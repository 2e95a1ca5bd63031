#include "ui/theme/style.h"

#include <QApplication>
#include <QFormLayout>
#include <QPainter>
#include <QPalette>
#include <QStyleOption>
#include <algorithm>

#include "ui/theme/tabs.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

Style::Style() : QProxyStyle(QStringLiteral("Fusion")) {
    setObjectName(QStringLiteral("covaria"));
}

int Style::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    const int usual = QProxyStyle::pixelMetric(metric, option, widget);
    if (metric != PM_TabBarTabHSpace) return usual;
    const auto* bar = qobject_cast<const TabBar*>(widget);
    return bar ? usual - bar->closer() : usual;
}

int Style::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                     QStyleHintReturn* data) const {
    if (hint == SH_FormLayoutWrapPolicy) return QFormLayout::WrapLongRows;
    if (hint != SH_Table_GridLineColor) return QProxyStyle::styleHint(hint, option, widget, data);
    const QPalette palette = option ? option->palette : QApplication::palette();
    return int(mix(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.16).rgb());
}

void Style::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                        const QWidget* widget) const {
    const auto* box =
        element == CE_ComboBoxLabel ? qstyleoption_cast<const QStyleOptionComboBox*>(option) : nullptr;
    if (!box || box->editable) return QProxyStyle::drawControl(element, option, painter, widget);
    QStyleOptionComboBox shown = *box;
    const int beside = box->currentIcon.isNull() ? 2 : box->iconSize.width() + 6;  // as the base style leaves
    const int room = subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget).width() - beside;
    shown.currentText = box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room);
    QProxyStyle::drawControl(element, &shown, painter, widget);
}

void Style::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                          const QWidget* widget) const {
    if (element != PE_IndicatorCheckBox) {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        return;
    }
    const QPalette& palette = option->palette;
    const bool enabled = option->state & State_Enabled;
    const auto group = enabled ? QPalette::Normal : QPalette::Disabled;
    // In a selected row it is an outline: filled with the ground of the others it would look ticked.
    const bool selected = option->state & State_Selected;
    const QColor ground = selected ? QColor(Qt::transparent) : palette.color(QPalette::Base);
    const QColor ink = palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const double side = std::min(option->rect.width(), option->rect.height());
    const QRectF box(option->rect.x() + 0.5, option->rect.y() + 0.5, side - 1.0, side - 1.0);
    const bool marked = option->state & (State_HasFocus | State_MouseOver);
    const QColor outline = selected            ? ink
                           : enabled && marked ? palette.color(QPalette::Highlight)
                                               : mix(ground, ink, 0.5);
    painter->setPen(QPen(outline, 1.0));
    painter->setBrush(ground);
    painter->drawRoundedRect(box, 2.0, 2.0);
    painter->setPen(QPen(ink, 0.14 * side, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [&](double x, double y) {
        return QPointF(box.x() + x * box.width(), box.y() + y * box.height());
    };
    if (option->state & State_On)
        painter->drawPolyline(QPolygonF{at(0.22, 0.54), at(0.42, 0.74), at(0.79, 0.28)});
    if (option->state & State_NoChange) painter->drawLine(at(0.25, 0.5), at(0.75, 0.5));
    painter->restore();
}

}  // namespace covaria::ui
