// Greedy placement: eight places around the anchor, near and then further out; the first free one.
#include "viz/scene/label_placement.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace covaria {
namespace {

struct Place {
    double x, y;  // -1 = left of / above the anchor, 0 = centred, 1 = right of / below
};
constexpr std::array<Place, 8> places{{{1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}}};

ScreenRect at_place(const LabelRequest& request, const Place& place, double distance) {
    // Diagonal places touch the circle of the clearance, not its square.
    const double d = place.x != 0 && place.y != 0 ? 0.75 * distance : distance;
    const double half_width = request.width / 2, half_height = request.height / 2;
    return {request.anchor.x + place.x * (d + half_width) - half_width,
            request.anchor.y + place.y * (d + (place.x == 0 ? half_height : 0.6 * half_height)) - half_height,
            request.width, request.height};
}

bool within(const ScreenRect& r, const ScreenRect& inside) {
    return r.x >= inside.x && r.y >= inside.y && r.x + r.width <= inside.x + inside.width &&
           r.y + r.height <= inside.y + inside.height;
}

std::optional<ScreenRect> free_place(const LabelRequest& request, const ScreenRect& inside,
                                     const std::vector<ScreenRect>& taken,
                                     const std::vector<ScreenRect>& drawn) {
    std::optional<ScreenRect> covering;
    for (double further : {0.0, 0.8, 1.8})
        for (const Place& place : places) {
            const ScreenRect rect = at_place(request, place, request.clearance + further * request.height);
            const auto hit = [&](const ScreenRect& other) { return rect.overlaps(other); };
            if (!within(rect, inside) || std::ranges::any_of(taken, hit)) continue;
            if (std::ranges::none_of(drawn, hit)) return rect;
            if (!covering) covering = rect;
        }
    return covering;
}

}  // namespace

bool ScreenRect::overlaps(const ScreenRect& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
           other.y < y + height;
}

std::vector<std::optional<ScreenRect>> place_labels(const std::vector<LabelRequest>& requests,
                                                    const ScreenRect& inside, std::vector<ScreenRect> taken,
                                                    const std::vector<ScreenRect>& drawn) {
    std::vector<std::size_t> order(requests.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return requests[a].priority > requests[b].priority;
    });
    std::vector<std::optional<ScreenRect>> placed(requests.size());
    for (std::size_t i : order) {
        placed[i] = free_place(requests[i], inside, taken, drawn);
        if (placed[i]) taken.push_back(*placed[i]);
    }
    return placed;
}

}  // namespace covaria
