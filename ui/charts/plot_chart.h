// A plot specification realised with Qt Charts: lines and points are its series, the rest is drawn around
// them.
#pragma once

#include <QChart>
#include <memory>

#include "ui/charts/chart_layout.h"
#include "ui/theme/theme.h"

class QValueAxis;

namespace covaria::ui {

class PlotChart : public QChart {
public:
    PlotChart(PlotSpecification plot, Theme theme);
    ~PlotChart() override;

    const PlotSpecification& plot() const { return plot_; }
    const Theme& theme() const { return theme_; }
    void set_theme(const Theme& theme);
    /// Shows this part of the data; `whole()` to begin with.
    void set_view(const PlotView& view);
    const PlotView& view() const { return view_; }
    PlotView whole() const { return whole_view(plot_); }
    const ChartLayout& chart_layout() const { return layout_; }

protected:
    void resizeEvent(QGraphicsSceneResizeEvent* event) override;

private:
    void add_series();
    void style_series();
    void place();

    PlotSpecification plot_;
    Theme theme_;
    PlotView view_;
    ChartLayout layout_;
    QValueAxis* x_axis_;
    QValueAxis* y_axis_;
    QGraphicsItem* below_;
    QGraphicsItem* above_;
};

}  // namespace covaria::ui
