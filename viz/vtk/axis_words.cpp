// Numbers and titles of the axes, on those edges of the box that are in front and clear of the scene.
#include <algorithm>
#include <array>
#include <cmath>

#include "viz/vtk/overlay.h"

namespace covaria::detail {
namespace {

using Vector = Eigen::Vector3d;

constexpr const char* names[] = {"x", "y", "z"};

Vector corner(const SceneAxes& axes, bool x_high, bool y_high, bool z_high) {
    return {x_high ? axes.high.x() : axes.low.x(), y_high ? axes.high.y() : axes.low.y(),
            z_high ? axes.high.z() : axes.low.z()};
}

/// Steps from one number to the next so that none is in the way of another: each tick has one, or each
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

std::vector<Overlay::AxisEdge> Overlay::axis_edges() const {
    std::vector<AxisEdge> edges;
    if (!scene_.axes) return edges;
    const SceneAxes& axes = *scene_.axes;
    const Camera& camera = view_.camera;
    const bool x_far = far_side_is_high(camera, 0), y_far = far_side_is_high(camera, 1),
               z_far = far_side_is_high(camera, 2);
    // The floor's (or ceiling's) edges nearest to the eye, and the upright edge farthest to the left.
    add_edge(0, corner(axes, false, !y_far, z_far), edges);
    add_edge(1, corner(axes, !x_far, false, z_far), edges);
    const Vector one = corner(axes, !x_far, y_far, false), other = corner(axes, x_far, !y_far, false);
    add_edge(2, pixel_of(one).x <= pixel_of(other).x ? one : other, edges);
    std::ranges::stable_sort(edges, {}, &AxisEdge::length);
    return edges;
}

void Overlay::add_edge(std::size_t axis, const Vector& begin, std::vector<AxisEdge>& edges) const {
    const SceneAxes& axes = *scene_.axes;
    Vector end = begin;
    end[Eigen::Index(axis)] = axes.high[Eigen::Index(axis)];
    const Pixel a = pixel_of(begin), b = pixel_of(end), middle = pixel_of((axes.low + axes.high) / 2);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length >= px(16)) || !std::isfinite(length)) return;
    Eigen::Vector2d out(-(b.y - a.y) / length, (b.x - a.x) / length);
    if (out.dot(Eigen::Vector2d((a.x + b.x) / 2 - middle.x, (a.y + b.y) / 2 - middle.y)) < 0) out = -out;
    edges.push_back({axis, begin, a, b, length, out});
}

void Overlay::paint_axes() {
    const std::vector<AxisEdge> edges = axis_edges();
    std::vector<std::optional<double>> reaches;
    for (const AxisEdge& edge : edges) reaches.push_back(paint_numbers(edge));
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const AxisEdge& edge = edges[i];
        // An axis without numbers needs no unit; its name alone still tells which axis it is.
        if (!reaches[i] || !paint_title(edge, scene_.axes->titles[edge.axis], *reaches[i]))
            paint_title(edge, names[edge.axis], reaches[i].value_or(0.0));
    }
}

std::vector<std::size_t> Overlay::numbered_ticks(const std::vector<ScreenRect>& needed,
                                                 const std::vector<AxisTick>& ticks) const {
    const std::size_t n = ticks.size();
    const double step = n < 2 ? 1.0 : ticks[1].at - ticks[0].at;
    const int each = stride(needed, ticks, step);
    std::vector<std::size_t> numbered;
    for (std::size_t i = 0; i < n; ++i)
        if (std::lround(ticks[i].at / step) % each == 0 && has_room(needed[i]) &&
            (numbered.empty() || !needed[i].overlaps(needed[numbered.back()])))
            numbered.push_back(i);
    if (numbered.size() >= 2) return numbered;
    for (std::size_t apart = n; apart-- > 1;)
        for (std::size_t first = 0; first + apart < n; ++first)
            if (has_room(needed[first]) && has_room(needed[first + apart]) &&
                !needed[first].overlaps(needed[first + apart]))
                return {first, first + apart};
    return {};
}

std::optional<double> Overlay::paint_numbers(const AxisEdge& edge) {
    canvas_.line(edge.from, edge.to, px(1.1), colour(Role::quiet_text), 0.9);
    const std::vector<AxisTick>& ticks = scene_.axes->ticks[edge.axis];
    const Eigen::Vector2d& out = edge.out;
    double farthest = 0.0;
    std::vector<Word> words;
    std::vector<Pixel> places;
    std::vector<ScreenRect> needed;
    for (const AxisTick& tick : ticks) {
        Vector p = edge.begin;
        p[Eigen::Index(edge.axis)] = tick.at;
        const Pixel at = pixel_of(p);
        places.push_back(at);
        words.push_back({tick.text, Role::quiet_text, false, 0.88});
        const TextMask& mask = mask_of(words.back());
        const double w = mask.letters.width, h = mask.letters.height;
        const double reach = px(7) + (std::abs(out.x()) * w + std::abs(out.y()) * h) / 2;
        needed.push_back(
            {at.x + reach * out.x() - w / 2 - px(3), at.y + reach * out.y() - h / 2, w + px(6), h});
        farthest = std::max(farthest, reach + (std::abs(out.x()) * w + std::abs(out.y()) * h) / 2);
    }
    const std::vector<std::size_t> numbered = numbered_ticks(needed, ticks);
    if (numbered.empty()) return std::nullopt;
    for (const Pixel& at : places)
        canvas_.line(at, {at.x + px(4) * out.x(), at.y + px(4) * out.y()}, px(1.1), colour(Role::quiet_text),
                     0.9);
    for (const std::size_t i : numbered) put(words[i], needed[i].x + px(3), needed[i].y);
    return farthest;
}

bool Overlay::paint_title(const AxisEdge& edge, const std::string& title, double numbers_reach) {
    const auto seen = ScreenLine{edge.from, edge.to}.part_in(whole());
    if (!seen) return true;  // nor is its axis
    const Word word{title, Role::text, false, 0.95};
    const TextMask& mask = mask_of(word);
    const double w = mask.letters.width, h = mask.letters.height, across = px(6), upright = px(3);
    const auto put_about = [&](double along, double away) {
        const double x = edge.from.x + along * (edge.to.x - edge.from.x) + away * edge.out.x() - w / 2;
        const double y = edge.from.y + along * (edge.to.y - edge.from.y) + away * edge.out.y() - h / 2;
        if (!has_room(ScreenRect{x, y, w, h}.grown(across, upright))) return false;
        put(word, x, y);
        return true;
    };
    const auto half_along = [&](double dx, double dy) {
        return (std::abs(dx) * (w + 2 * across) + std::abs(dy) * (h + 2 * upright)) / 2;
    };
    const double half = half_along(edge.out.x(), edge.out.y());
    const double beside = std::max(numbers_reach, px(8)) + half;
    const auto put_beside = [&](double part, double away) {
        return put_about((*seen)[0] + part * ((*seen)[1] - (*seen)[0]), away);
    };
    constexpr std::array parts{0.5, 0.62, 0.38, 0.74, 0.26, 0.88, 0.12};
    for (const double part : parts)
        if (put_beside(part, beside) || put_beside(part, beside + h / 2)) return true;
    // Beyond an end of the axis, else on its inner side.
    const double beyond = (px(3) + half_along(edge.out.y(), edge.out.x())) / edge.length;
    return put_about((*seen)[1] + beyond, 0.0) || put_about((*seen)[0] - beyond, 0.0) ||
           std::ranges::any_of(parts, [&](double part) { return put_beside(part, -px(4) - half); });
}

}  // namespace covaria::detail
