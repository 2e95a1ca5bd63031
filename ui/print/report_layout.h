// A report document as a flow of printed items.
#pragma once

#include <vector>

#include "core/report/report_document.h"
#include "ui/print/figure_layout.h"
#include "ui/print/flow.h"
#include "ui/print/page_style.h"

namespace covaria::ui {

struct FigurePainters {
    PaintPlot paint_plot;
    RenderScene render_scene;
};

std::vector<FlowItem> lay_out(const ReportDocument& document, const PageStyle& style,
                              const FigurePainters& figures);

}  // namespace covaria::ui
