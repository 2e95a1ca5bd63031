// Placement of labels so that they collide with nothing: greedy, in screen space.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "viz/scene/camera.h"

namespace covaria {

/// A rectangle in pixels, y down.
struct ScreenRect {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    bool overlaps(const ScreenRect& other) const;
    bool contains(const ScreenRect& other) const;
    ScreenRect grown(double across, double upright) const;  ///< by so much to each side
    bool operator==(const ScreenRect&) const = default;
};

ScreenRect square_about(Pixel middle, double half);

/// A line as it is drawn, in pixels; without length, a square.
struct ScreenLine {
    Pixel from, to;
    double half_width = 0.0;
    /// Part of its length, from 0 to 1, on which its middle is in `rect`; nullopt: none.
    std::optional<std::array<double, 2>> part_in(const ScreenRect& rect) const;
    bool crosses(const ScreenRect& rect) const;
};

struct LabelRequest {
    Pixel anchor;
    double width = 0.0, height = 0.0;
    double clearance = 0.0;  ///< distance to keep from the anchor
    int priority = 0;
    double gap = 0.0;        ///< distance to the next label on its line: touching ones are read as one
    bool is_needed = false;  ///< whatever it covers
};

/// The line from the anchor to a label that stands apart from it.
std::optional<ScreenLine> leader_of(const LabelRequest& request, const ScreenRect& label);

/// Positions in the order of the requests; empty where there was no room within `inside` and outside of
/// `taken`. Higher priority first, then in order. As little of `drawn` is covered as there is room for,
/// nothing of `bodies`, unless a label that is needed has no room else, and no leader runs through a label.
std::vector<std::optional<ScreenRect>> place_labels(const std::vector<LabelRequest>& requests,
                                                    const ScreenRect& inside, std::vector<ScreenRect> taken,
                                                    std::vector<ScreenLine> drawn = {},
                                                    const std::vector<ScreenLine>& bodies = {});

}  // namespace covaria
