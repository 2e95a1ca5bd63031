#include "ui/theme/style.h"

#include <QFormLayout>
#include <QPainter>
#include <QStyleOption>

#include "ui/theme/flat_parts.h"
#include "ui/theme/tabs.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

Style::Style() : QProxyStyle(QStringLiteral("Fusion")) {
    setObjectName(QStringLiteral("covaria"));
}

int Style::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    const int usual = QProxyStyle::pixelMetric(metric, option, widget);
    if (metric == PM_TabBarTabVSpace) return usual + 8;  // 36 px high at the usual size
    if (metric == PM_TabBarTabShiftVertical || metric == PM_TabBarTabOverlap) return 0;
    if (metric != PM_TabBarTabHSpace) return usual;
    const auto* bar = qobject_cast<const TabBar*>(widget);
    return bar ? usual - bar->closer() : usual;
}

int Style::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                     QStyleHintReturn* data) const {
    if (hint == SH_FormLayoutWrapPolicy) return QFormLayout::WrapLongRows;
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons || hint == SH_Widget_Animation_Duration) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
}

void Style::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                          const QWidget* widget) const {
    if (!draw_flat(element, *option, *painter, widget))
        QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void Style::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                        const QWidget* widget) const {
    if (!draw_flat(element, *option, *painter, widget) && !draw_label(element, *option, *painter, widget))
        QProxyStyle::drawControl(element, option, painter, widget);
}

/// Draws labels that are shortened, or have another ink than the palette of their ground says.
bool Style::draw_label(ControlElement element, const QStyleOption& option, QPainter& painter,
                       const QWidget* widget) const {
    const Tokens& t = tokens_of(option.palette);
    if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(&option);
        box && element == CE_ComboBoxLabel && !box->editable) {
        QStyleOptionComboBox shown = *box;
        const int beside =
            box->currentIcon.isNull() ? 2 : box->iconSize.width() + 6;  // px, as in the base style
        const int room = subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget).width() - beside;
        shown.currentText = box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room);
        QProxyStyle::drawControl(element, &shown, &painter, widget);
        return true;
    }
    if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(&option);
        tab && element == CE_TabBarTabLabel) {
        QStyleOptionTab shown = *tab;
        const bool current = tab->state & (State_Selected | State_MouseOver);
        shown.palette.setColor(QPalette::WindowText, current ? t.ink : t.ink2);
        QProxyStyle::drawControl(element, &shown, &painter, widget);
        return true;
    }
    if (const auto* head = qstyleoption_cast<const QStyleOptionHeader*>(&option);
        head && element == CE_HeaderLabel) {
        QStyleOptionHeader shown = *head;
        shown.palette.setColor(QPalette::ButtonText, t.ink2);
        QProxyStyle::drawControl(element, &shown, &painter, widget);
        return true;
    }
    if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(&option);
        button && element == CE_PushButtonLabel && (button->features & QStyleOptionButton::DefaultButton) &&
        (button->state & State_Enabled)) {
        QStyleOptionButton shown = *button;
        shown.palette.setColor(QPalette::ButtonText, t.on_blue);
        QProxyStyle::drawControl(element, &shown, &painter, widget);
        return true;
    }
    return false;
}

void Style::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                               const QWidget* widget) const {
    const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
    if (control == CC_ComboBox && box)
        draw_combo_box(*box, *painter, widget);
    else if (control == CC_SpinBox && spin)
        draw_spin_box(*spin, *painter, widget);
    else
        QProxyStyle::drawComplexControl(control, option, painter, widget);
}

void Style::draw_combo_box(const QStyleOptionComboBox& box, QPainter& painter, const QWidget* widget) const {
    const Tokens& t = tokens_of(box.palette);
    if (box.frame) {
        draw_field(painter, box, box.state & State_HasFocus);
    } else {
        painter.fillRect(box.rect, box.palette.color(QPalette::Base));
    }
    const QRect arrow = subControlRect(CC_ComboBox, &box, SC_ComboBoxArrow, widget);
    draw_chevron(painter, arrow, box.state & State_Enabled ? t.ink2 : t.ink3, Qt::DownArrow);
}

void Style::draw_spin_box(const QStyleOptionSpinBox& box, QPainter& painter, const QWidget* widget) const {
    const Tokens& t = tokens_of(box.palette);
    if (box.frame) draw_field(painter, box, box.state & State_HasFocus);
    if (box.buttonSymbols == QAbstractSpinBox::NoButtons) return;
    const auto arrow = [&](SubControl part, bool can, Qt::ArrowType to) {
        const QRect rect = subControlRect(CC_SpinBox, &box, part, widget);
        draw_chevron(painter, rect, can && (box.state & State_Enabled) ? t.ink2 : t.line2, to);
    };
    arrow(SC_SpinBoxUp, box.stepEnabled & QAbstractSpinBox::StepUpEnabled, Qt::UpArrow);
    arrow(SC_SpinBoxDown, box.stepEnabled & QAbstractSpinBox::StepDownEnabled, Qt::DownArrow);
}

}  // namespace covaria::ui
