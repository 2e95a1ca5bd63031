#include "viz/scene/clear_corner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace covaria {
namespace {

// Least scale against the whole picture. A long scene, which fills the width of a picture that is not
// much wider than high, needs 0.7 to pass below a legend of six lines.
constexpr double smallest = 0.65;
constexpr double step = 6.0;  // pixels

/// A projected box with its ends in the picture.
struct Shape {
    std::array<Pixel, 8> corners;
    double left = 0.0, right = 0.0, bottom = 0.0;
};

Shape shape_of(const Camera& camera, const SceneBounds& bounds, PictureSize size) {
    Shape shape;
    std::ranges::transform(corners_of(bounds), shape.corners.begin(),
                           [&](const Eigen::Vector3d& corner) { return project(camera, size, corner); });
    const auto [left, right] = std::ranges::minmax(shape.corners, {}, &Pixel::x);
    shape.left = left.x;
    shape.right = right.x;
    shape.bottom = std::ranges::max(shape.corners, {}, &Pixel::y).y;
    return shape;
}

/// Whether a convex shape that is moved by (dx, dy) has nothing before `right` above `bottom`. Lines between
/// any two corners include the edges of the shape.
bool is_clear(const Shape& shape, double dx, double dy, double right, double bottom) {
    if (shape.left + dx >= right) return true;
    // The part of a convex shape to the left of `right` is highest at a corner or where a line crosses it.
    for (const Pixel& a : shape.corners) {
        if (a.x + dx < right && a.y + dy < bottom) return false;
        for (const Pixel& b : shape.corners) {
            const double from = a.x + dx, to = b.x + dx;
            if (!(from < right && to > right)) continue;
            if (a.y + dy + (b.y - a.y) * (right - from) / (to - from) < bottom) return false;
        }
    }
    return true;
}

/// The shortest way on which it stays in the picture.
std::optional<Pixel> way_out(const Shape& shape, PictureSize size, double right, double bottom, double room) {
    const double most_right = std::max(0.0, size.width - room - shape.right);
    const double most_down = std::max(0.0, size.height - room - shape.bottom);
    std::optional<Pixel> best;
    const auto length = [](const Pixel& way) { return std::hypot(way.x, way.y); };
    for (double dx = 0.0; dx <= most_right; dx += step)
        for (double dy = 0.0; dy <= most_down; dy += step) {
            const Pixel way{dx, dy};
            if (best && length(*best) <= length(way)) break;
            if (is_clear(shape, dx, dy, right, bottom)) best = way;
        }
    return best;
}

}  // namespace

Camera clear_of_corner(const Camera& camera, const SceneBounds& bounds, PictureSize size,
                       const ScreenRect& taken, double room) {
    if (!(taken.width > 0.0)) return camera;
    const double right = taken.x + taken.width + room, bottom = taken.y + taken.height;
    for (double scale = 1.0; scale >= smallest; scale -= 0.02) {
        const Camera farther = zoomed(camera, scale);
        const Shape shape = shape_of(farther, bounds, size);
        const auto way = way_out(shape, size, right, bottom, room);
        if (!way) continue;
        const Camera moved = panned(farther, size, way->x, way->y);
        // Parts far away have moved less than that in a perspective.
        constexpr double rounding = 1e-6;
        if (is_clear(shape_of(moved, bounds, size), 0.0, 0.0, right - rounding, bottom - rounding))
            return moved;
    }
    return camera;
}

}  // namespace covaria
