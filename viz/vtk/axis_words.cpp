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

void Overlay::paint_axis(int axis, const Vector& from, const Vector& to) {
    const SceneAxes& axes = *scene_.axes;
    const Pixel a = pixel_of(from), b = pixel_of(to), middle = pixel_of((axes.low + axes.high) / 2);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < px(40)) return;  // seen from its end
    Eigen::Vector2d out(-(b.y - a.y) / length, (b.x - a.x) / length);
    if (out.dot(Eigen::Vector2d((a.x + b.x) / 2 - middle.x, (a.y + b.y) / 2 - middle.y)) < 0) out = -out;
    canvas_.line(a, b, px(1.1), colour(Role::quiet_text), 0.9);
    double farthest = 0.0;
    for (const AxisTick& tick : axes.ticks[static_cast<std::size_t>(axis)]) {
        Vector p = from;
        p[axis] = tick.at;
        const Pixel at = pixel_of(p);
        canvas_.line(at, {at.x + px(4) * out.x(), at.y + px(4) * out.y()}, px(1.1), colour(Role::quiet_text),
                     0.9);
        const Word word{tick.text, Role::quiet_text, false, 0.88};
        const TextMask& mask = mask_of(word);
        const double w = mask.letters.width, h = mask.letters.height;
        const double reach = px(7) + (std::abs(out.x()) * w + std::abs(out.y()) * h) / 2;
        const ScreenRect rect{at.x + reach * out.x() - w / 2, at.y + reach * out.y() - h / 2, w, h};
        if (!is_free({rect.x - px(3), rect.y, rect.width + px(6), rect.height})) continue;
        put(word, rect.x, rect.y);
        farthest = std::max(farthest, reach + (std::abs(out.x()) * w + std::abs(out.y()) * h) / 2);
    }
    const Word title{axes.titles[static_cast<std::size_t>(axis)], Role::text, false, 0.95};
    const TextMask& mask = mask_of(title);
    const double w = mask.letters.width, h = mask.letters.height;
    const double reach =
        std::max(farthest, px(8)) + px(3) + (std::abs(out.x()) * w + std::abs(out.y()) * h) / 2;
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
