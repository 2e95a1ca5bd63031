// The value under the pointer, in words.
#pragma once

#include <optional>

#include "ui/charts/plot_geometry.h"

namespace covaria::ui {

struct ReadOut {
    Text text;
    std::optional<QPointF> point;         ///< place of the value, where it is a point
    std::optional<std::size_t> bar = {};  ///< number of the horizontal bar
};

/// The cell of a map or of a histogram that holds `place`, the bar in its row, or the point of a series
/// within `reach`; nothing elsewhere.
std::optional<ReadOut> read_out(const PlotSpecification& plot, const PlotGeometry& geometry, QPointF place,
                                double reach = 16.0);

}  // namespace covaria::ui
