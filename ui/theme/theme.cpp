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
    Neutrals n;
    n.ground = 0xffffff;
    n.panel = 0xf3f4f5;
    n.text = 0x1c1f23;
    n.quiet = 0x5d646c;
    n.disabled = 0x666d74;
    n.rule = 0x8b929a;
    n.grid = 0xe6e8ea;
    n.band = 0xf0f1f3;
    n.accent = 0x1f5a8a;
    n.on_accent = 0xffffff;
    return {false, n};
}

Theme Theme::with_numbers(const NumberLocale& numbers) const {
    Theme other = *this;
    other.numbers_ = numbers;
    return other;
}

Theme Theme::dark() {
    Neutrals n;
    n.ground = 0x1e2125;
    n.panel = 0x282c31;
    n.text = 0xe6e9ec;
    n.quiet = 0xa7aeb6;
    n.disabled = 0x9098a0;
    n.rule = 0x7c848d;
    n.grid = 0x33383e;
    n.band = 0x292e33;
    n.accent = 0x6aaede;
    n.on_accent = 0x10161b;
    return {true, n};
}

QColor Theme::series(SeriesRole role) const {
    switch (role) {
        case SeriesRole::data:
        case SeriesRole::monte_carlo:
            return dark_ ? 0x56b4e9 : 0x0072b2;
        case SeriesRole::fit:
            return dark_ ? 0xf0823a : 0xd55e00;
        case SeriesRole::first_order:
            return dark_ ? 0x2bc497 : 0x007f5c;
        case SeriesRole::emphasis:
            return dark_ ? 0xe6c14a : 0x8a3d6e;
        case SeriesRole::reference:
            return neutrals_.quiet;
        case SeriesRole::family_1:
            return dark_ ? 0x56b4e9 : 0x0072b2;
        case SeriesRole::family_2:
            return dark_ ? 0xf0823a : 0xd55e00;
        case SeriesRole::family_3:
            return dark_ ? 0x2bc497 : 0x009e73;
        case SeriesRole::family_4:
            return dark_ ? 0xe6a5c9 : 0xb05a8a;
        case SeriesRole::family_5:
            return dark_ ? 0xe6c14a : 0xb8860b;
        case SeriesRole::family_6:
            return neutrals_.text;
    }
    return neutrals_.text;
}

QColor Theme::filling(SeriesRole role) const {
    return mix(series(role), neutrals_.ground, dark_ ? 0.50 : 0.52);
}

QColor Theme::sequential(double t) const {
    return along(viridis, t);
}

Theme Theme::of(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128 ? dark() : light();
}

QColor Theme::diverging(double t) const {
    return along(dark_ ? diverging_dark : diverging_light, 0.5 * (std::clamp(t, -1.0, 1.0) + 1.0));
}

QColor Theme::text_on(const QColor& ground) {
    const QColor black(0x14, 0x17, 0x1a), white(Qt::white);
    return contrast(ground, black) >= contrast(ground, white) ? black : white;
}

}  // namespace covaria::ui
