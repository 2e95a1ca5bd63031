// Colours of the window and of charts.
#include "ui/theme/theme.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace covaria::ui {
namespace {

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

template <std::size_t n>
QColor along(const std::array<QRgb, n>& points, double t) {
    const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(n - 1);
    const auto first = std::min(static_cast<std::size_t>(place), n - 2);
    return mix(QColor(points[first]), QColor(points[first + 1]), place - static_cast<double>(first));
}

constexpr std::array<QRgb, 9> viridis = {0xff440154, 0xff472d7b, 0xff3b528b, 0xff2c728e, 0xff21918c,
                                         0xff28ae80, 0xff5ec962, 0xffaddc30, 0xfffde725};
constexpr std::array<QRgb, 7> diverging_light = {0xff005a8f, 0xff4a93c2, 0xffa9cde3, 0xfff4f4f3,
                                                 0xfff3bf9c, 0xffdd7f47, 0xffb04a00};
constexpr std::array<QRgb, 7> diverging_dark = {0xff6fc1f2, 0xff3f86b4, 0xff315871, 0xff2b3035,
                                                0xff6f4a32, 0xffb9683a, 0xfff59a5c};

}  // namespace

QColor mix(const QColor& from, const QColor& to, double t) {
    const auto channel = [t](float a, float b) { return static_cast<float>(a + t * (b - a)); };
    return QColor::fromRgbF(channel(from.redF(), to.redF()), channel(from.greenF(), to.greenF()),
                            channel(from.blueF(), to.blueF()));
}

double contrast(const QColor& a, const QColor& b) {
    const double one = luminance(a), other = luminance(b);
    return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

Theme Theme::light() {
    Tokens t;
    t.chrome = 0xf0f2f4;
    t.panel = 0xf7f8f9;
    t.stage = 0xffffff;
    t.line = 0xdde1e5;
    t.line2 = 0xb9c0c8;
    t.field_line = 0x8b939c;
    t.hover = 0xe9ecef;
    t.ink = 0x16191d;
    t.ink2 = 0x4c545d;
    t.ink3 = 0x626a74;
    t.blue = 0x1563a8;
    t.on_blue = 0xffffff;
    t.fill = 0x2f7fc0;
    t.tint = 0xe6f0f9;
    t.orange = 0xd97f0c;
    t.type_a = 0x8a4a00;
    t.green = 0x17703f;
    t.green_tint = 0xe3f3ea;
    t.red = 0xb0281e;
    t.red_tint = 0xfbe8e5;
    return {false, t};
}

Theme Theme::with_numbers(const NumberLocale& numbers) const {
    Theme other = *this;
    other.numbers_ = numbers;
    return other;
}

Theme Theme::dark() {
    Tokens t;
    t.chrome = 0x1f2226;
    t.panel = 0x23272c;
    t.stage = 0x1b1e22;
    t.line = 0x343a41;
    t.line2 = 0x4d555e;
    t.field_line = 0x69727c;
    t.hover = 0x2b3036;
    t.ink = 0xeceef0;
    t.ink2 = 0xb3bac2;
    t.ink3 = 0x98a0aa;
    t.blue = 0x74b6ee;
    t.on_blue = 0x10161b;
    t.fill = 0x4b9bdd;
    t.tint = 0x1c3346;
    t.orange = 0xf0a23c;
    t.type_a = 0xf7c787;
    t.green = 0x6fd09a;
    t.green_tint = 0x1b3528;
    t.red = 0xff9489;
    t.red_tint = 0x45231f;
    return {true, t};
}

QColor Theme::series(SeriesRole role) const {
    switch (role) {
        case SeriesRole::data:
        case SeriesRole::monte_carlo:
        case SeriesRole::family_1:
            return tokens_.fill;
        case SeriesRole::fit:
            return dark_ ? 0xf0823a : 0xd55e00;
        case SeriesRole::first_order:
            return dark_ ? 0x2bc497 : 0x007f5c;
        case SeriesRole::emphasis:
            return dark_ ? 0xe6c14a : 0x8a3d6e;
        case SeriesRole::reference:
            return tokens_.ink2;
        case SeriesRole::family_2:
            return dark_ ? 0xf0823a : 0xd55e00;
        case SeriesRole::family_3:
            return dark_ ? 0x2bc497 : 0x009e73;
        case SeriesRole::family_4:
            return dark_ ? 0xe6a5c9 : 0xb05a8a;
        case SeriesRole::family_5:
            return dark_ ? 0xe6c14a : 0xb8860b;
        case SeriesRole::family_6:
            return tokens_.ink;
    }
    return tokens_.ink;
}

QColor Theme::filling(SeriesRole role) const {
    return mix(series(role), tokens_.stage, dark_ ? 0.50 : 0.52);
}

QColor Theme::sequential(double t) const {
    return along(viridis, t);
}

Theme Theme::of(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128 ? dark() : light();
}

const Tokens& tokens_of(const QPalette& palette) {
    static const Theme light = Theme::light(), dark = Theme::dark();
    return (palette.color(QPalette::Window).lightness() < 128 ? dark : light).tokens();
}

QColor Theme::diverging(double t) const {
    return along(dark_ ? diverging_dark : diverging_light, 0.5 * (std::clamp(t, -1.0, 1.0) + 1.0));
}

QColor Theme::text_on(const QColor& ground) {
    const QColor black(0x14, 0x17, 0x1a), white(Qt::white);
    return contrast(ground, black) >= contrast(ground, white) ? black : white;
}

}  // namespace covaria::ui
