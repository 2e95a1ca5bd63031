// The Fusion style with what it lacks for us: grid lines and check boxes seen on dark ground, long choices
// that end in dots, tabs closer where there is little room, and fields of forms under their labels where both
// have no room beside each other.
#pragma once

#include <QProxyStyle>

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
};

}  // namespace covaria::ui
