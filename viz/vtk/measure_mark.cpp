// Drawing of the measuring tool: the places, the line or the arc between them, and the value.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "viz/vtk/overlay.h"

namespace covaria::detail {
namespace {

bool is_near_picture(Pixel at) {
    return std::abs(at.x) < 1e5 && std::abs(at.y) < 1e5;
}

}  // namespace

void Overlay::paint_measure() {
    std::vector<Pixel> at;
    for (const Eigen::Vector3d& p : view_.measure.at) at.push_back(pixel_of(p));
    if (at.empty() || !std::all_of(at.begin(), at.end(), is_near_picture)) return;
    const Colour ink = selection_colour(view_.palette), ground = ground_colour(view_.palette);
    for (std::size_t i = 1; i < at.size(); ++i) {
        canvas_.line(at[i - 1], at[i], px(4.0), ground, 0.7);
        canvas_.line(at[i - 1], at[i], px(1.8), ink);
    }
    for (const Pixel& place : at) {
        canvas_.ring(place, px(7), px(4.0), ground, 0.8);
        canvas_.ring(place, px(7), px(2.0), ink);
    }
    if (at.size() == 3) paint_arc(at[0], at[1], at[2]);
    if (view_.measure.text.empty()) return;
    for (const Pixel& place : at) taken_.push_back(square_about(place, px(9)));
    const Pixel& from = at[0];
    const Pixel& to = at[1];
    paint_measured_value(at.size() == 3 ? to : Pixel{(from.x + to.x) / 2, (from.y + to.y) / 2});
}

void Overlay::paint_arc(Pixel from, Pixel apex, Pixel to) {
    const double first = std::atan2(from.y - apex.y, from.x - apex.x);
    const double turn =
        std::remainder(std::atan2(to.y - apex.y, to.x - apex.x) - first, 2 * std::numbers::pi);
    const double radius = std::min({px(34), std::hypot(from.x - apex.x, from.y - apex.y) / 2,
                                    std::hypot(to.x - apex.x, to.y - apex.y) / 2});
    constexpr int pieces = 24;
    const auto on_arc = [&](int i) {
        const double angle = first + turn * i / pieces;
        return Pixel{apex.x + radius * std::cos(angle), apex.y + radius * std::sin(angle)};
    };
    for (int i = 0; i < pieces; ++i)
        canvas_.line(on_arc(i), on_arc(i + 1), px(1.8), selection_colour(view_.palette));
}

/// Paints the value on a ground of its own, away from other words: beside the line, else further up or down.
void Overlay::paint_measured_value(Pixel at) {
    const Word word{view_.measure.text, Role::text, true, 1.0};
    const TextMask& mask = mask_of(word);
    const double w = mask.letters.width, h = mask.letters.height, gap = px(5);
    const double x = std::clamp(at.x - w / 2, gap, std::max(gap, canvas_.size().width - w - gap));
    double y = at.y + 2 * gap;
    const double lowest = std::max(gap, canvas_.size().height - view_.covered - h - gap);
    for (int tried = 0; tried < 25; ++tried) {
        const int step = tried % 2 == 0 ? tried / 2 : -(tried + 1) / 2;
        y = std::clamp(at.y + 2 * gap + step * (h + 3 * gap), gap, lowest);
        if (is_free({x - gap, y - gap, w + 2 * gap, h + 2 * gap})) break;
    }
    canvas_.rectangle({x - gap, y - gap, w + 2 * gap, h + 2 * gap}, ground_colour(view_.palette), 0.85);
    put(word, x, y);
}

}  // namespace covaria::detail
