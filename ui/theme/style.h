// The Fusion style drawn flat: no shadow, gradient or animation; fields and buttons with one line around
// them, tabs with a line below the current one, quiet tables. Besides, what Fusion lacks for us: long choices
// that end in dots, tabs closer where there is little room, and fields of forms under their labels where both
// have no room beside each other.
#pragma once

#include <QProxyStyle>

class QStyleOptionComboBox;
class QStyleOptionSpinBox;

namespace covaria::ui {

class Style : public QProxyStyle {
public:
    Style();
    int pixelMetric(PixelMetric metric, const QStyleOption* option = nullptr,
                    const QWidget* widget = nullptr) const override;
    int styleHint(StyleHint hint, const QStyleOption* option = nullptr, const QWidget* widget = nullptr,
                  QStyleHintReturn* data = nullptr) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget = nullptr) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget = nullptr) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget = nullptr) const override;

private:
    bool draw_label(ControlElement element, const QStyleOption& option, QPainter& painter,
                    const QWidget* widget) const;
    void draw_combo_box(const QStyleOptionComboBox& box, QPainter& painter, const QWidget* widget) const;
    void draw_spin_box(const QStyleOptionSpinBox& box, QPainter& painter, const QWidget* widget) const;
};

}  // namespace covaria::ui
