// Figures of a printed report: charts (in pairs where they follow one another) and pictures, with their
// captions.
#include "ui/print/figure_layout.h"

#include <algorithm>

#include "core/text/symbol.h"
#include "ui/print/rich_text.h"

namespace covaria::ui {
namespace {

constexpr double picture_dots_per_mm = 200.0 / 25.4;
constexpr double least_dots_per_mm = 130.0 / 25.4;  // a small picture stays small

RichText caption_of(const std::string& caption, const PageStyle& style, double width) {
    RichText text(style, TextRole::note, QString::fromStdString(to_html(running_text(caption))));
    text.set_width(width);
    return text;
}

struct Figure {
    QRectF rect;  ///< relative to the item's top left corner
    PlotSpecification plot;
    RichText caption;
};

/// One row of figures as one item: chart and caption never part.
FlowItem row_of(const std::vector<Figure>& figures, const PageStyle& style, const PaintPlot& paint_plot) {
    const double space = style.points(3.0);
    double height = 0.0;
    for (const Figure& figure : figures)
        height = std::max(height, figure.rect.height() + space + figure.caption.height());
    const auto paint = [figures, paint_plot, space](QPainter& painter, QPointF at) {
        for (const Figure& figure : figures) {
            painter.save();
            paint_plot(painter, figure.rect.translated(at), figure.plot);
            painter.restore();
            figure.caption.paint(painter, at + figure.rect.bottomLeft() + QPointF(0.0, space),
                                 PageStyle::quiet());
        }
    };
    return {height, style.mm(4.0), false, paint, {}};
}

bool is_map(const PlotSpecification& plot) {
    return std::any_of(plot.series.begin(), plot.series.end(),
                       [](const PlotSeries& series) { return series.kind == SeriesKind::heat_map; });
}

/// Width of a figure that stands alone, in mm: a map grows with its cells.
double lone_width(const PlotSpecification& plot) {
    if (!is_map(plot)) return 125.0;
    return std::clamp(30.0 + 8.0 * static_cast<double>(plot.x.categories.size()), 60.0, 115.0);
}

}  // namespace

void append_plots(std::vector<FlowItem>& items, const std::vector<const PlotBlock*>& plots,
                  const PageStyle& style, const PaintPlot& paint_plot) {
    const double whole = style.text_area().width();
    const double gap = style.mm(6.0);
    const double half = 0.5 * (whole - gap);
    for (std::size_t i = 0; i < plots.size();) {
        const bool pair = i + 1 < plots.size() && !is_map(plots[i]->plot) && !is_map(plots[i + 1]->plot);
        std::vector<Figure> row;
        for (std::size_t side = 0; side < (pair ? 2U : 1U); ++side) {
            const PlotBlock& block = *plots[i + side];
            const double width = pair ? half : style.mm(lone_width(block.plot));
            const double height = width * (pair ? 0.68 : is_map(block.plot) ? 0.9 : 0.6);
            const QRectF rect(static_cast<double>(side) * (half + gap), 0.0, width, height);
            row.push_back({rect, block.plot, caption_of(block.caption, style, pair ? half : whole)});
        }
        items.push_back(row_of(row, style, paint_plot));
        i += row.size();
    }
}

void append_scene(std::vector<FlowItem>& items, const SceneBlock& scene, const PageStyle& style,
                  const RenderScene& render_scene) {
    const double width = style.text_area().width();
    const double dots = picture_dots_per_mm * width / style.mm(1.0);
    append_picture(items, render_scene(scene, QSize(static_cast<int>(dots), static_cast<int>(0.625 * dots))),
                   scene.caption, style);
}

void append_picture(std::vector<FlowItem>& items, const QImage& image, const std::string& caption_words,
                    const PageStyle& style) {
    const double width =
        std::min(style.text_area().width(), image.width() * style.mm(1.0) / least_dots_per_mm);
    const std::string words =
        image.isNull() ? caption_words + " (The picture could not be drawn.)" : caption_words;
    const RichText caption = caption_of(words, style, style.text_area().width());
    const double height = image.isNull() ? 0.0 : width * image.height() / image.width();
    const double space = style.points(3.0);
    const auto paint = [image, caption, width, height, space](QPainter& painter, QPointF at) {
        if (!image.isNull()) painter.drawImage(QRectF(at, QSizeF(width, height)), image);
        caption.paint(painter, at + QPointF(0.0, height + space), PageStyle::quiet());
    };
    items.push_back({height + space + caption.height(), style.mm(3.0), false, paint, {}});
}

}  // namespace covaria::ui
