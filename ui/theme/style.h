// The Fusion style with what it lacks for us: grid lines seen on dark ground.
#pragma once

#include <QProxyStyle>

namespace covaria::ui {

class Style : public QProxyStyle {
public:
    Style();
    int styleHint(StyleHint hint, const QStyleOption* option = nullptr, const QWidget* widget = nullptr,
                  QStyleHintReturn* data = nullptr) const override;
};

}  // namespace covaria::ui
