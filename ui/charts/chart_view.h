// A chart in the window: zoom by rubber band and wheel, the value under the pointer, pictures and data to
// files and clipboard.
#pragma once

#include <QGraphicsView>
#include <memory>

#include "core/base/error.h"
#include "ui/charts/plot_chart.h"
#include "ui/charts/read_out.h"

class QRubberBand;

namespace covaria::ui {

class ChartView : public QGraphicsView {
    Q_OBJECT
public:
    explicit ChartView(QWidget* parent = nullptr);
    ~ChartView() override;

    /// Shows a chart; keeps the zoom if it is a newer version of the same chart (its id). Without series the
    /// title is shown as a message.
    void set_plot(PlotSpecification plot);
    const PlotSpecification& plot() const;
    void set_theme(const Theme& theme);
    /// Makes the first `count` bars lead somewhere (`bar_clicked`), and the pointer says so.
    void set_clickable_bars(int count) { clickable_bars_ = count; }
    const PlotChart& chart() const { return *chart_; }

    bool is_zoomed() const;
    void reset_zoom();
    /// Shows what is inside `rect` (of the viewport), or `factor` times as much around `centre`.
    void zoom_to(const QRectF& rect);
    void zoom_by(double factor, QPointF centre);

    /// Writes what is shown (csv: all data), by the ending of the name: png, svg or csv. Errors: bad_input
    /// for another ending, io.
    Result<void> save(const QString& file) const;
    void copy_image() const;
    void copy_data() const;
    /// Asks for a file, then saves; `ending`: "png", "svg", "csv".
    void save_as(const QString& ending);

signals:
    void read_out_changed(const QString& text);  ///< empty when the pointer is on nothing
    void saved(const QString& file);
    /// A horizontal bar was clicked: its number, from 0.
    void bar_clicked(int bar);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;

private:
    void replace_chart(PlotSpecification plot);
    void show_read_out(const std::optional<ReadOut>& read_out);
    bool can_zoom() const;
    bool is_over_link() const;

    Theme theme_;
    PlotChart* chart_ = nullptr;  // owned by the scene
    std::optional<ReadOut> read_out_;
    int clickable_bars_ = 0;
    std::optional<QPoint> pressed_;
    QRubberBand* band_;
};

}  // namespace covaria::ui
