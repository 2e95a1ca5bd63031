// A chart in the window.
#include "ui/charts/chart_view.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QGraphicsScene>
#include <QMessageBox>
#include <QRubberBand>
#include <algorithm>

#include "core/result_files/csv_writer.h"
#include "core/views/plots.h"
#include "ui/charts/chart_painter.h"
#include "ui/theme/number_locale.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr double least_zoomed_part = 1e-3;  // least part of the whole range that zooming in may show

/// Moves [low, high] into [least, most], and cuts what is larger.
void keep_inside(double& low, double& high, double least, double most) {
    const double size = std::clamp(high - low, least_zoomed_part * (most - least), most - least);
    low = std::clamp(low, least, most - size);
    high = low + size;
    if (high > low) return;  // else there is no number between them to zoom in to
    low = least;
    high = most;
}

PlotView inside_whole(PlotView view, const PlotView& whole) {
    keep_inside(view.x_low, view.x_high, whole.x_low, whole.x_high);
    keep_inside(view.y_low, view.y_high, whole.y_low, whole.y_high);
    return view;
}

Theme in_words_of_the_user(const Theme& theme) {
    return theme.with_numbers(user_numbers());
}

}  // namespace

ChartView::ChartView(QWidget* parent)
    : QGraphicsView(parent),
      theme_(in_words_of_the_user(Theme::light())),
      band_(new QRubberBand(QRubberBand::Rectangle, viewport())) {
    setScene(new QGraphicsScene(this));
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setViewportUpdateMode(FullViewportUpdate);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, 160);
    replace_chart({});
}

ChartView::~ChartView() = default;

void ChartView::replace_chart(PlotSpecification plot) {
    if (plot.series.empty() && plot.title.empty())
        plot.title = tr("Run the analysis to see this chart").toStdString();
    delete chart_;
    chart_ = new PlotChart(std::move(plot), theme_);
    scene()->addItem(chart_);
    chart_->setAcceptedMouseButtons(Qt::NoButton);
    chart_->resize(viewport()->size());
    scene()->setSceneRect(QRectF(QPointF(), viewport()->size()));
    setBackgroundBrush(theme_.tokens().stage);
    setAccessibleName(to_qt(to_unicode(chart_->plot().title)));
    show_read_out({});
}

void ChartView::set_plot(PlotSpecification plot) {
    const PlotView view = chart_->view();
    const bool keep = is_zoomed() && plot.id == chart_->plot().id && !plot.series.empty();
    replace_chart(std::move(plot));
    if (keep) chart_->set_view(inside_whole(view, chart_->whole()));
}

const PlotSpecification& ChartView::plot() const {
    return chart_->plot();
}

void ChartView::set_theme(const Theme& theme) {
    theme_ = in_words_of_the_user(theme);
    setBackgroundBrush(theme_.tokens().stage);
    chart_->set_theme(theme_);
}

bool ChartView::can_zoom() const {
    return !plot().series.empty() && !has_heat_map(plot()) && plot().y.categories.empty();
}

bool ChartView::is_zoomed() const {
    return !(chart_->view() == chart_->whole());
}

void ChartView::reset_zoom() {
    chart_->set_view(chart_->whole());
    show_read_out({});
}

void ChartView::zoom_to(const QRectF& rect) {
    const PlotGeometry& geometry = chart_->chart_layout().geometry;
    const QRectF inside = rect.intersected(geometry.area);
    if (!can_zoom() || inside.width() < 4.0 || inside.height() < 4.0) return;
    const QPointF low = geometry.coordinates_at(inside.bottomLeft()),
                  high = geometry.coordinates_at(inside.topRight());
    chart_->set_view(inside_whole({low.x(), high.x(), low.y(), high.y()}, chart_->whole()));
    show_read_out({});
}

void ChartView::zoom_by(double factor, QPointF centre) {
    const PlotGeometry& geometry = chart_->chart_layout().geometry;
    if (!can_zoom() || !geometry.area.contains(centre)) return;
    const QPointF fixed = geometry.coordinates_at(centre);
    const PlotView& v = chart_->view();
    const PlotView wanted{
        fixed.x() + factor * (v.x_low - fixed.x()), fixed.x() + factor * (v.x_high - fixed.x()),
        fixed.y() + factor * (v.y_low - fixed.y()), fixed.y() + factor * (v.y_high - fixed.y())};
    chart_->set_view(inside_whole(wanted, chart_->whole()));
    show_read_out({});
}

Result<void> ChartView::save(const QString& file) const {
    const QString ending = file.section(u'.', -1).toLower();
    const ShownPlot shown{plot(), theme_, viewport()->size(), chart_->view()};
    if (ending == QStringLiteral("png")) return write_png(file.toStdString(), shown);
    if (ending == QStringLiteral("svg")) return write_svg(file.toStdString(), shown);
    if (ending == QStringLiteral("csv")) return write_csv(file.toStdString(), plot());
    return fail(ErrorCode::bad_input,
                "cannot tell the format of " + file.toStdString() + ": end its name in .png, .svg or .csv");
}

void ChartView::copy_image() const {
    QApplication::clipboard()->setImage(
        plot_image({plot(), theme_, viewport()->size(), chart_->view()}, 2.0));
}

void ChartView::copy_data() const {
    QApplication::clipboard()->setText(to_qt(plot_csv(plot())));
}

void ChartView::save_as(const QString& ending) {
    const QString name = to_qt(plot().id) + u'.' + ending;
    const QString filter = tr("%1 files (*.%2)").arg(ending.toUpper(), ending);
    QString file = QFileDialog::getSaveFileName(this, tr("Save Chart"), name, filter);
    if (file.isEmpty()) return;
    if (!file.endsWith(u'.' + ending, Qt::CaseInsensitive)) file += u'.' + ending;
    const auto written = save(file);
    if (written)
        emit saved(file);
    else
        QMessageBox::warning(this, tr("Save Chart"), to_qt(written.error().message));
}

}  // namespace covaria::ui
