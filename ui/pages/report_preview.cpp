#include "ui/pages/report_preview.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/export/scene_pictures.h"
#include "ui/pages/current_results.h"
#include "ui/print/report_pages.h"

namespace covaria::ui {
namespace {

constexpr int preview_dots_per_inch = 96;

std::vector<QImage> pages_of(const RecordedReport& report) {
    ScenePictures scenes(report.analyses);
    PdfOptions options;
    options.paint_plot = [&](QPainter& painter, const QRectF& area, const PlotSpecification& plot) {
        report.play(painter, area, plot);
    };
    options.render_scene = [&](const SceneBlock& block, QSize size) { return scenes.render(block, size); };
    return page_images(report.document, options, preview_dots_per_inch);
}

}  // namespace

ReportPreview::ReportPreview(Document& document, AnalysisRunner& runner, QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner) {
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 4, 8, 4);
    state_ = new QLabel(tr("The report has not been made yet."));
    auto* update = new QPushButton(tr("Update"));
    head->addWidget(state_, 1);
    head->addWidget(update);
    area_ = new QScrollArea;
    area_->setFrameShape(QFrame::NoFrame);
    area_->setWidgetResizable(true);
    area_->setBackgroundRole(QPalette::Mid);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(head);
    column->addWidget(area_, 1);
    connect(update, &QPushButton::clicked, this, &ReportPreview::refresh);
    connect(&document_, &Document::project_changed, this, &ReportPreview::mark_old);
    connect(&runner_, &AnalysisRunner::result_changed, this, &ReportPreview::mark_old);
}

void ReportPreview::mark_old() {
    old_ = true;
    if (pages_ > 0) state_->setText(tr("Out of date: the project or its results have changed since."));
}

void ReportPreview::showEvent(QShowEvent*) {
    if (old_ && pages_ == 0) refresh();
}

void ReportPreview::refresh() {
    const auto results = current_results(document_.project(), runner_);
    if (results.empty()) {
        state_->setText(tr("No analysis is up to date: run one first (F5)."));
        return;
    }
    old_ = false;
    state_->setText(tr("Making the report …"));
    recorder_.record(document_.snapshot(), results,
                     [this](const RecordedReport& report) -> JobQueue::Delivery {
                         const std::vector<QImage> images = pages_of(report);
                         return [this, images] { show_pages(images); };
                     });
}

void ReportPreview::show_pages(const std::vector<QImage>& images) {
    auto* sheets = new QWidget;
    auto* column = new QVBoxLayout(sheets);
    column->setSpacing(16);
    for (const QImage& image : images) {
        auto* sheet = new QLabel;
        sheet->setPixmap(QPixmap::fromImage(image));
        sheet->setFrameShape(QFrame::Box);
        column->addWidget(sheet, 0, Qt::AlignHCenter);
    }
    area_->setWidget(sheets);
    pages_ = images.size();
    if (!old_) state_->setText(tr("%n page(s), as printed", nullptr, int(pages_)));
}

}  // namespace covaria::ui
