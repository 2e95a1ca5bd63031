// Figures of a printed report: charts (in pairs where they follow one another) and pictures, with their
// captions.
#pragma once

#include <QImage>
#include <QPainter>
#include <functional>
#include <vector>

#include "core/document/report_document.h"
#include "ui/print/flow.h"
#include "ui/print/page_style.h"

namespace covaria::ui {

using PaintPlot = std::function<void(QPainter&, const QRectF&, const PlotSpecification&)>;
/// A null image is an admission that there is no picture.
using RenderScene = std::function<QImage(const SceneBlock&, QSize)>;

void append_plots(std::vector<FlowItem>& items, const std::vector<const PlotBlock*>& plots,
                  const PageStyle& style, const PaintPlot& paint_plot);
void append_scene(std::vector<FlowItem>& items, const SceneBlock& scene, const PageStyle& style,
                  const RenderScene& render_scene);

void append_picture(std::vector<FlowItem>& items, const QImage& image, const std::string& caption,
                    const PageStyle& style);

}  // namespace covaria::ui
