// Blending of marks into the bytes of a picture.
#include "viz/vtk/canvas.h"

#include <algorithm>
#include <cmath>

namespace covaria::detail {
namespace {

/// Part of a pixel inside an edge at signed distance d (negative = inside).
double coverage(double d) {
    return std::clamp(0.5 - d, 0.0, 1.0);
}

}  // namespace

void Canvas::blend(int x, int y, Colour colour, double opacity) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height || opacity <= 0) return;
    std::uint8_t* pixel =
        &image_.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                          static_cast<std::size_t>(x))];
    const std::uint8_t values[3] = {colour.red, colour.green, colour.blue};
    for (int i = 0; i < 3; ++i)
        pixel[i] = static_cast<std::uint8_t>(std::lround(pixel[i] + opacity * (values[i] - pixel[i])));
    pixel[3] = 255;
}

void Canvas::rectangle(const ScreenRect& rect, Colour colour, double opacity) {
    const int x0 = static_cast<int>(std::floor(rect.x)),
              x1 = static_cast<int>(std::ceil(rect.x + rect.width));
    const int y0 = static_cast<int>(std::floor(rect.y)),
              y1 = static_cast<int>(std::ceil(rect.y + rect.height));
    for (int y = std::max(0, y0); y < std::min(image_.height, y1); ++y)
        for (int x = std::max(0, x0); x < std::min(image_.width, x1); ++x) {
            const double w = std::min(x + 1.0, rect.x + rect.width) - std::max<double>(x, rect.x);
            const double h = std::min(y + 1.0, rect.y + rect.height) - std::max<double>(y, rect.y);
            blend(x, y, colour, opacity * w * h);
        }
}

void Canvas::line(Pixel from, Pixel to, double width, Colour colour, double opacity) {
    const double dx = to.x - from.x, dy = to.y - from.y, length2 = dx * dx + dy * dy;
    const double reach = width / 2 + 1;
    const int y1 = std::min(image_.height - 1, static_cast<int>(std::max(from.y, to.y) + reach));
    const int x1 = std::min(image_.width - 1, static_cast<int>(std::max(from.x, to.x) + reach));
    for (int y = std::max(0, static_cast<int>(std::min(from.y, to.y) - reach)); y <= y1; ++y)
        for (int x = std::max(0, static_cast<int>(std::min(from.x, to.x) - reach)); x <= x1; ++x) {
            const double px = x + 0.5 - from.x, py = y + 0.5 - from.y;
            const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
            blend(x, y, colour, opacity * coverage(std::hypot(px - t * dx, py - t * dy) - width / 2));
        }
}

void Canvas::ring(Pixel centre, double radius, double width, Colour colour, double opacity) {
    const double reach = radius + width / 2 + 1;
    for (int y = static_cast<int>(centre.y - reach); y <= centre.y + reach; ++y)
        for (int x = static_cast<int>(centre.x - reach); x <= centre.x + reach; ++x) {
            const double r = std::hypot(x + 0.5 - centre.x, y + 0.5 - centre.y);
            blend(x, y, colour, opacity * coverage(std::abs(r - radius) - width / 2));
        }
}

void Canvas::ellipse(Pixel centre, double half_width, double half_height, Colour colour, double opacity) {
    for (int y = static_cast<int>(centre.y - half_height - 1); y <= centre.y + half_height + 1; ++y)
        for (int x = static_cast<int>(centre.x - half_width - 1); x <= centre.x + half_width + 1; ++x) {
            const double r =
                std::hypot((x + 0.5 - centre.x) / half_width, (y + 0.5 - centre.y) / half_height);
            blend(x, y, colour, opacity * coverage((r - 1) * std::min(half_width, half_height)));
        }
}

void Canvas::paint(const Mask& mask, int x, int y, Colour colour, double opacity) {
    for (int row = 0; row < mask.height; ++row)
        for (int column = 0; column < mask.width; ++column)
            blend(x + column, y + row, colour, opacity * mask.at(column, row) / 255.0);
}

void Canvas::text(const TextMask& mask, double x, double y, Colour colour, Colour halo) {
    const int left = static_cast<int>(std::lround(x)), top = static_cast<int>(std::lround(y));
    paint(mask.halo, left - mask.halo_width, top - mask.halo_width, halo, 0.88);
    paint(mask.letters, left, top, colour, 1.0);
}

}  // namespace covaria::detail
