// Group and legend of a picture: what stands in its upper left corner.
#pragma once

#include <vector>

#include "viz/scene/label_placement.h"
#include "viz/vtk/canvas.h"

namespace covaria::detail {

struct Word {
    Text text;
    Role role = Role::text;
    bool bold = false;
    double scale = 1.0;  ///< factor on the size of letters
};

inline constexpr double letter_size = 11.0;
inline constexpr double picture_margin = 16.0;
inline constexpr double ground_opacity = 0.8;  ///< under words that stand on what is drawn

/// The name of the group, an entry of the legend, or a remark.
struct HeadLine {
    Word word;
    double x = 0.0, y = 0.0;
    const LegendLine* legend = nullptr;
};

/// Lives as long as `scene`: group and swatches in a row, as many rows as its width in pixels needs; remarks
/// below, each on its line.
std::vector<HeadLine> head_lines(const Scene& scene, const LayerVisibility& layers, double ratio, int width,
                                 TextMasks& masks);
/// The ground of the legend's lines; it has no width without any.
ScreenRect legend_ground(const std::vector<HeadLine>& lines, double ratio, TextMasks& masks);

}  // namespace covaria::detail
