// Greedy placement: twelve places around the anchor, near and then further out; the first free one, else the
// one that covers least.
#include "viz/scene/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace covaria {
namespace {

struct Place {
    double x, y;  // -1 = left of / above the anchor, 0 = centred, 1 = right of / below
};
constexpr std::array<Place, 12> places{{{1, -1},
                                        {1, 1},
                                        {-1, -1},
                                        {-1, 1},
                                        {1, 0},
                                        {-1, 0},
                                        {0, -1},
                                        {0, 1},
                                        {0.5, -1},
                                        {0.5, 1},
                                        {-0.5, -1},
                                        {-0.5, 1}}};
// Lines; a label across more is read with difficulty, and hides them.
constexpr std::ptrdiff_t most_covered = 3;

ScreenRect at_place(const LabelRequest& request, const Place& place, double distance) {
    // Diagonal places touch the circle of the clearance, not its square.
    const bool beside = std::abs(place.x) == 1;
    const double d = beside && place.y != 0 ? 0.75 * distance : distance;
    const double half_width = request.width / 2, half_height = request.height / 2;
    return {request.anchor.x + place.x * (d + half_width) - half_width,
            request.anchor.y + place.y * (d + (beside ? 0.6 * half_height : half_height)) - half_height,
            request.width, request.height};
}

/// The places taken so far, and the labels that are added to them.
class Placement {
public:
    Placement(const ScreenRect& inside, std::vector<ScreenRect> taken, std::vector<ScreenLine> drawn,
              const std::vector<ScreenLine>& bodies)
        : inside_(inside), taken_(std::move(taken)), drawn_(std::move(drawn)), bodies_(bodies) {}

    std::optional<ScreenRect> place(const LabelRequest& request) {
        auto found = best_place(request, bodies_);
        if (!found && request.is_needed) found = best_place(request, {});
        if (!found) return found;
        labels_.push_back(*found);
        taken_.push_back(found->grown(request.gap, 0.0));
        if (const auto leader = leader_of(request, *found)) drawn_.push_back(*leader);
        return found;
    }

private:
    std::optional<ScreenRect> best_place(const LabelRequest& request,
                                         const std::vector<ScreenLine>& bodies) const {
        std::optional<ScreenRect> best;
        auto least = request.is_needed ? std::numeric_limits<std::ptrdiff_t>::max() : most_covered + 1;
        for (double further : {0.0, 0.8, 1.8, 3.0, 4.5, 6.5, 9.0})
            for (const Place& place : places) {
                const ScreenRect rect =
                    at_place(request, place, request.clearance + further * request.height);
                if (!has_room(request, rect)) continue;
                if (std::ranges::any_of(bodies, [&](const ScreenLine& body) { return body.crosses(rect); }))
                    continue;
                const auto covered =
                    std::ranges::count_if(drawn_, [&](const ScreenLine& line) { return line.crosses(rect); });
                if (covered == 0) return rect;
                if (covered >= least) continue;
                least = covered;
                best = rect;
            }
        return best;
    }

    bool has_room(const LabelRequest& request, const ScreenRect& rect) const {
        if (!inside_.contains(rect)) return false;
        if (std::ranges::any_of(taken_, [&](const ScreenRect& t) { return t.overlaps(rect); })) return false;
        const auto leader = leader_of(request, rect);
        return !leader ||
               std::ranges::none_of(labels_, [&](const ScreenRect& label) { return leader->crosses(label); });
    }

    ScreenRect inside_;
    std::vector<ScreenRect> taken_, labels_;
    std::vector<ScreenLine> drawn_;
    const std::vector<ScreenLine>& bodies_;
};

}  // namespace

bool ScreenRect::overlaps(const ScreenRect& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
           other.y < y + height;
}

bool ScreenRect::contains(const ScreenRect& other) const {
    return other.x >= x && other.y >= y && other.x + other.width <= x + width &&
           other.y + other.height <= y + height;
}

ScreenRect ScreenRect::grown(double across, double upright) const {
    return {x - across, y - upright, width + 2 * across, height + 2 * upright};
}

ScreenRect square_about(Pixel middle, double half) {
    return {middle.x - half, middle.y - half, 2 * half, 2 * half};
}

std::optional<std::array<double, 2>> ScreenLine::part_in(const ScreenRect& rect) const {
    std::array<double, 2> part{0.0, 1.0};
    const auto clip = [&part](double start, double step, double low, double high) {
        if (step == 0.0) return start >= low && start <= high;
        const auto [enter, leave] = std::minmax({(low - start) / step, (high - start) / step});
        part = {std::max(part[0], enter), std::min(part[1], leave)};
        return part[0] <= part[1];
    };
    if (!clip(from.x, to.x - from.x, rect.x, rect.x + rect.width) ||
        !clip(from.y, to.y - from.y, rect.y, rect.y + rect.height))
        return std::nullopt;
    return part;
}

bool ScreenLine::crosses(const ScreenRect& rect) const {
    return part_in(rect.grown(half_width, half_width)).has_value();
}

std::optional<ScreenLine> leader_of(const LabelRequest& request, const ScreenRect& label) {
    const Pixel end{std::clamp(request.anchor.x, label.x, label.x + label.width),
                    std::clamp(request.anchor.y, label.y, label.y + label.height)};
    const double dx = end.x - request.anchor.x, dy = end.y - request.anchor.y, length = std::hypot(dx, dy);
    if (length < request.clearance + 0.7 * request.height) return std::nullopt;
    const double begin = request.clearance / length;
    return ScreenLine{{request.anchor.x + begin * dx, request.anchor.y + begin * dy}, end};
}

std::vector<std::optional<ScreenRect>> place_labels(const std::vector<LabelRequest>& requests,
                                                    const ScreenRect& inside, std::vector<ScreenRect> taken,
                                                    std::vector<ScreenLine> drawn,
                                                    const std::vector<ScreenLine>& bodies) {
    std::vector<std::size_t> order(requests.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return requests[a].priority > requests[b].priority;
    });
    Placement placement(inside, std::move(taken), std::move(drawn), bodies);
    std::vector<std::optional<ScreenRect>> placed(requests.size());
    for (std::size_t i : order) placed[i] = placement.place(requests[i]);
    return placed;
}

}  // namespace covaria
