// A plot specification realised with Qt Charts.
#include "ui/charts/plot_chart.h"

#include <QLineSeries>
#include <QPainter>
#include <QScatterSeries>
#include <QValueAxis>
#include <cmath>

#include "ui/charts/chart_drawing.h"

namespace covaria::ui {
namespace {

/// The part of the drawing below or above the series.
class DrawingItem : public QGraphicsItem {
public:
    DrawingItem(PlotChart& chart, bool above) : QGraphicsItem(&chart), chart_(chart), above_(above) {
        setZValue(above ? 1000.0 : 0.5);
        setAcceptedMouseButtons(Qt::NoButton);
    }
    QRectF boundingRect() const override { return QRectF(QPointF(), chart_.size()); }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
        painter->setRenderHint(QPainter::Antialiasing);
        const ChartDrawing drawing{chart_.plot(), chart_.chart_layout(), chart_.theme()};
        above_ ? draw_above(*painter, drawing) : draw_below(*painter, drawing, boundingRect());
    }
    void follow() {
        prepareGeometryChange();
        update();
    }

private:
    PlotChart& chart_;
    bool above_;
};

QXYSeries* make_series(const PlotSeries& data, const PlotSpecification& plot) {
    QXYSeries* series = nullptr;
    if (data.kind == SeriesKind::line) series = new QLineSeries;
    if (data.kind == SeriesKind::points) series = new QScatterSeries;
    if (!series) return nullptr;
    QList<QPointF> points;
    for (std::size_t i = 0; i < data.x.size() && i < data.y.size(); ++i) {
        const QPointF at(on_axis(plot.x, data.x[i]), on_axis(plot.y, data.y[i]));
        if (std::isfinite(at.x()) && std::isfinite(at.y())) points << at;
    }
    series->replace(points);
    series->setProperty("role", static_cast<int>(data.role));
    return series;
}

}  // namespace

PlotChart::PlotChart(PlotSpecification plot, Theme theme)
    : plot_(std::move(plot)),
      theme_(std::move(theme)),
      view_(whole_view(plot_)),
      x_axis_(new QValueAxis(this)),
      y_axis_(new QValueAxis(this)),
      below_(new DrawingItem(*this, false)),
      above_(new DrawingItem(*this, true)) {
    legend()->hide();
    setMargins({});
    setBackgroundVisible(false);
    setAnimationOptions(NoAnimation);
    y_axis_->setReverse(!plot_.y.categories.empty());
    addAxis(x_axis_, Qt::AlignBottom);
    addAxis(y_axis_, Qt::AlignLeft);
    x_axis_->setVisible(false);
    y_axis_->setVisible(false);
    add_series();
    place();
}

PlotChart::~PlotChart() = default;

void PlotChart::add_series() {
    for (const PlotSeries& data : plot_.series) {
        QXYSeries* series = make_series(data, plot_);
        if (!series) continue;
        addSeries(series);
        series->attachAxis(x_axis_);
        series->attachAxis(y_axis_);
    }
}

void PlotChart::style_series() {
    for (QAbstractSeries* each : series()) {
        const auto role = static_cast<SeriesRole>(each->property("role").toInt());
        if (auto* points = qobject_cast<QScatterSeries*>(each)) {
            points->setMarkerSize(5.4 * layout_.fonts.scale);
            points->setBorderColor(Qt::transparent);
            points->setPen(Qt::NoPen);
            points->setColor(theme_.series(role));
        } else if (auto* line = qobject_cast<QLineSeries*>(each)) {
            line->setPen(pen_of(role, theme_, layout_.fonts.scale));
        }
    }
}

void PlotChart::place() {
    layout_ = layout_chart(plot_, size(), view_, theme_.numbers());
    x_axis_->setRange(view_.x_low, view_.x_high);
    y_axis_->setRange(view_.y_low, view_.y_high);
    if (!plot_.series.empty()) setPlotArea(layout_.geometry.area);
    style_series();
    static_cast<DrawingItem*>(below_)->follow();
    static_cast<DrawingItem*>(above_)->follow();
}

void PlotChart::set_theme(const Theme& theme) {
    theme_ = theme;
    place();
}

void PlotChart::set_view(const PlotView& view) {
    view_ = view;
    place();
}

void PlotChart::resizeEvent(QGraphicsSceneResizeEvent* event) {
    QChart::resizeEvent(event);
    place();
}

}  // namespace covaria::ui
