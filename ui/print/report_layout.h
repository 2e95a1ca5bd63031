// A report document as a flow of printed items.
#pragma once

#include <memory>
#include <vector>

#include "core/document/report_document.h"
#include "ui/print/figure_layout.h"
#include "ui/print/flow.h"
#include "ui/print/page_style.h"

namespace covaria::ui {

struct FigurePainters {
    PaintPlot paint_plot;
    RenderScene render_scene;
};

/// Pages of the headings in their order, known when all is placed and before anything is painted.
using HeadingPages = std::shared_ptr<std::vector<int>>;

std::vector<FlowItem> lay_out(const ReportDocument& document, const PageStyle& style,
                              const FigurePainters& figures, const HeadingPages& pages);

}  // namespace covaria::ui
