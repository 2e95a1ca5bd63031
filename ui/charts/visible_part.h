// The data inside a view: for formats without clipping (SVG of Qt).
#pragma once

#include "ui/charts/plot_geometry.h"

namespace covaria::ui {

/// Lines cut at the edges of the view, points outside it left out. A line that leaves the view and comes back
/// becomes several series; the first one keeps the name.
PlotSpecification visible_part(const PlotSpecification& plot, const PlotView& view);

}  // namespace covaria::ui
