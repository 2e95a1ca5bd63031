#include "ui/theme/theme.h"

#include <QApplication>
#include <QFontDatabase>
#include <QStyleFactory>
#include <algorithm>
#include <cmath>

namespace covaria::ui {
namespace {

QColor mixed(const QColor& a, const QColor& b, double t) {
    const auto channel = [t](int x, int y) { return int(std::lround(x + t * (y - x))); };
    return {channel(a.red(), b.red()), channel(a.green(), b.green()), channel(a.blue(), b.blue())};
}

const QColor okabe_ito_orange(0xE6, 0x9F, 0x00), okabe_ito_sky(0x56, 0xB4, 0xE9),
    okabe_ito_green(0x00, 0x9E, 0x73), okabe_ito_blue(0x00, 0x72, 0xB2),
    okabe_ito_vermillion(0xD5, 0x5E, 0x00);

}  // namespace

const Theme& Theme::light() {
    static const Theme theme(false);
    return theme;
}

const Theme& Theme::dark() {
    static const Theme theme(true);
    return theme;
}

Theme::Theme(bool dark) : dark_(dark) {
    window_ = dark ? QColor(0x2b, 0x2d, 0x30) : QColor(0xf3, 0xf4, 0xf5);
    base_ = dark ? QColor(0x1f, 0x21, 0x23) : QColor(0xff, 0xff, 0xff);
    text_ = dark ? QColor(0xe4, 0xe6, 0xe8) : QColor(0x1c, 0x1f, 0x23);
    quiet_ = dark ? QColor(0x9b, 0xa1, 0xa8) : QColor(0x5d, 0x64, 0x6c);
    line_ = dark ? QColor(0x45, 0x49, 0x4e) : QColor(0xd3, 0xd7, 0xdb);
    accent_ = dark ? okabe_ito_sky : okabe_ito_blue;
}

QColor Theme::of(SeriesRole role) const {
    switch (role) {
        case SeriesRole::data:
            return dark_ ? okabe_ito_sky : okabe_ito_blue;
        case SeriesRole::fit:
            return okabe_ito_vermillion;
        case SeriesRole::reference:
            return quiet_;
        case SeriesRole::first_order:
            return okabe_ito_orange;
        case SeriesRole::monte_carlo:
            return dark_ ? okabe_ito_sky : okabe_ito_blue;
        case SeriesRole::emphasis:
            return okabe_ito_green;
    }
    return text_;
}

QColor Theme::diverging(double t) const {
    const double strength = std::min(1.0, std::abs(t));
    return mixed(base_, t < 0 ? okabe_ito_blue : okabe_ito_vermillion, 0.85 * strength);
}

QPalette Theme::palette() const {
    QPalette palette;
    palette.setColor(QPalette::Window, window_);
    palette.setColor(QPalette::Base, base_);
    palette.setColor(QPalette::AlternateBase, mixed(base_, window_, dark_ ? 0.5 : 0.6));
    palette.setColor(QPalette::Button, dark_ ? mixed(window_, text_, 0.07) : mixed(window_, base_, 0.6));
    for (QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
        palette.setColor(role, text_);
    palette.setColor(QPalette::ToolTipBase, base_);
    palette.setColor(QPalette::PlaceholderText, quiet_);
    palette.setColor(QPalette::Highlight, okabe_ito_blue);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, accent_);
    palette.setColor(QPalette::LinkVisited, accent_);
    palette.setColor(QPalette::BrightText, okabe_ito_vermillion);
    palette.setColor(QPalette::Light, mixed(window_, base_, 0.5));
    palette.setColor(QPalette::Midlight, mixed(window_, line_, 0.3));
    palette.setColor(QPalette::Mid, line_);
    palette.setColor(QPalette::Dark, mixed(line_, text_, 0.2));
    palette.setColor(QPalette::Shadow, dark_ ? QColor(0x10, 0x11, 0x12) : mixed(line_, text_, 0.4));
    for (QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, mixed(quiet_, window_, 0.3));
    return palette;
}

QFont application_font() {
    const QStringList families = QFontDatabase::families();
    QFont font;
    for (const char* family : {"Inter", "Liberation Sans", "DejaVu Sans"})
        if (families.contains(QLatin1String(family))) {
            font = QFont(QLatin1String(family));
            break;
        }
    font.setPointSizeF(9.0);
    return font;
}

void apply_theme(QApplication& application, const Theme& theme) {
    if (application.style()->name().compare(QStringLiteral("fusion"), Qt::CaseInsensitive) != 0)
        application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    application.setPalette(theme.palette());
    application.setFont(application_font());
}

}  // namespace covaria::ui
