// Where labels go so that they collide with nothing: greedy, in screen space.
#pragma once

#include <optional>
#include <vector>

#include "viz/scene/camera.h"

namespace covaria {

/// In pixels, y down.
struct ScreenRect {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    bool overlaps(const ScreenRect& other) const;
};

struct LabelRequest {
    Pixel anchor;
    double width = 0.0, height = 0.0;
    double clearance = 0.0;  ///< distance to keep from the anchor
    int priority = 0;
};

/// Positions in the order of the requests; empty where there was no room within `inside` and outside of
/// `taken`. Higher priority first, then in order. `drawn` is covered only where there is no other room.
std::vector<std::optional<ScreenRect>> place_labels(const std::vector<LabelRequest>& requests,
                                                    const ScreenRect& inside, std::vector<ScreenRect> taken,
                                                    const std::vector<ScreenRect>& drawn = {});

}  // namespace covaria
