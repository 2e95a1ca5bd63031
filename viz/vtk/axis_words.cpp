// Numbers and titles of the axes, on those edges of the box that are in front and clear of the scene.
#include <algorithm>
#include <cmath>

#include "viz/vtk/overlay.h"

namespace covaria::detail {
namespace {

using Vector = Eigen::Vector3d;

Vector corner(const SceneAxes& axes, bool x_high, bool y_high, bool z_high) {
    return {x_high ? axes.high.x() : axes.low.x(), y_high ? axes.high.y() : axes.low.y(),
            z_high ? axes.high.z() : axes.low.z()};
}

/// How many steps from one number to the next so that none is in the way of another: all of them, or each
/// second, fifth, tenth, counted from zero.
int stride(const std::vector<ScreenRect>& words, const std::vector<AxisTick>& ticks, double step) {
    for (const int each : {1, 2, 5}) {
        const ScreenRect* before = nullptr;
        bool fits = true;
        for (std::size_t i = 0; i < words.size() && fits; ++i) {
            if (std::lround(ticks[i].at / step) % each != 0) continue;
            fits = !before || !words[i].overlaps(*before);
            before = &words[i];
        }
        if (fits) return each;
    }
    return 10;
}

}  // namespace

void Overlay::paint_axes() {
    if (!scene_.axes) return;
    const SceneAxes& axes = *scene_.axes;
    const Camera& camera = view_.camera;
    const bool x_far = far_side_is_high(camera, 0), y_far = far_side_is_high(camera, 1),
               z_far = far_side_is_high(camera, 2);
    // The floor's (or ceiling's) edges nearest to the eye, and the upright edge farthest to the left.
    paint_axis(0, corner(axes, false, !y_far, z_far), corner(axes, true, !y_far, z_far));
    paint_axis(1, corner(axes, !x_far, false, z_far), corner(axes, !x_far, true, z_far));
    const Vector one = corner(axes, !x_far, y_far, false), other = corner(axes, x_far, !y_far, false);
    const Vector low = pixel_of(one).x <= pixel_of(other).x ? one : other;
    Vector high = low;
    high.z() = axes.high.z();
    paint_axis(2, low, high);
}

std::vector<std::size_t> Overlay::numbered_ticks(const std::vector<ScreenRect>& needed,
                                                 const std::vector<AxisTick>& ticks) const {
    const std::size_t n = ticks.size();
    const double step = n < 2 ? 1.0 : ticks[1].at - ticks[0].at;
    const int each = stride(needed, ticks, step);
    std::vector<std::size_t> numbered;
    for (std::size_t i = 0; i < n; ++i)
        if (std::lround(ticks[i].at / step) % each == 0 && is_free(needed[i]) &&
            (numbered.empty() || !needed[i].overlaps(needed[numbered.back()])))
            numbered.push_back(i);
    if (numbered.size() >= 2) return numbered;
    for (std::size_t apart = n; apart-- > 1;)
        for (std::size_t first = 0; first + apart < n; ++first)
            if (is_free(needed[first]) && is_free(needed[first + apart]) &&
                !needed[first].overlaps(needed[first + apart]))
                return {first, first + apart};
    return {};
}

double Overlay::paint_ticks(int axis, const Vector& from, const Eigen::Vector2d& out) {
    double farthest = 0.0;
    const std::vector<AxisTick>& ticks = scene_.axes->ticks[static_cast<std::size_t>(axis)];
    std::vector<Word> words;
    std::vector<ScreenRect> needed;
    for (const AxisTick& tick : ticks) {
        Vector p = from;
        p[axis] = tick.at;
        const Pixel at = pixel_of(p);
        canvas_.line(at, {at.x + px(4) * out.x(), at.y + px(4) * out.y()}, px(1.1), colour(Role::quiet_text),
                     0.9);
        words.push_back({tick.text, Role::quiet_text, false, 0.88});
        const TextMask& mask = mask_of(words.back());
        const double w = mask.letters.width, h = mask.letters.height;
        const double reach = px(7) + (std::abs(out.x()) * w + std::abs(out.y()) * h) / 2;
        needed.push_back(
            {at.x + reach * out.x() - w / 2 - px(3), at.y + reach * out.y() - h / 2, w + px(6), h});
        farthest = std::max(farthest, reach + (std::abs(out.x()) * w + std::abs(out.y()) * h) / 2);
    }
    for (const std::size_t i : numbered_ticks(needed, ticks)) put(words[i], needed[i].x + px(3), needed[i].y);
    return farthest;
}

void Overlay::paint_axis(int axis, const Vector& from, const Vector& to) {
    const SceneAxes& axes = *scene_.axes;
    const Pixel a = pixel_of(from), b = pixel_of(to), middle = pixel_of((axes.low + axes.high) / 2);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < px(16)) return;  // seen from its end
    Eigen::Vector2d out(-(b.y - a.y) / length, (b.x - a.x) / length);
    if (out.dot(Eigen::Vector2d((a.x + b.x) / 2 - middle.x, (a.y + b.y) / 2 - middle.y)) < 0) out = -out;
    canvas_.line(a, b, px(1.1), colour(Role::quiet_text), 0.9);
    const double farthest = paint_ticks(axis, from, out);
    const Word title{axes.titles[static_cast<std::size_t>(axis)], Role::text, false, 0.95};
    const TextMask& mask = mask_of(title);
    const double w = mask.letters.width, h = mask.letters.height;
    const double reach =
        std::max(farthest, px(8)) + px(3) + (std::abs(out.x()) * (w + px(12)) + std::abs(out.y()) * h) / 2;
    for (double along : {0.5, 0.62, 0.38, 0.74, 0.26}) {  // beside the middle, else where nothing stands yet
        const double x = std::clamp(a.x + along * (b.x - a.x) + reach * out.x() - w / 2, 2.0,
                                    canvas_.size().width - w - 2);
        const double y = a.y + along * (b.y - a.y) + reach * out.y() - h / 2;
        if (!is_free({x - px(6), y, w + px(12), h})) continue;
        put(title, x, y);
        return;
    }
}

}  // namespace covaria::detail
