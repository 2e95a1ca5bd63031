#include "ui/export/report_recorder.h"

#include <QPainter>
#include <QTimer>

#include "ui/charts/chart_painter.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

namespace {
constexpr double recorded_width =
    420.0;  // text of 9 points is then legible where the chart is printed 80 mm wide
constexpr double recorded_height = 0.68 * recorded_width;
}  // namespace

struct ReportRecorder::Job {
    quint64 number = 0;
    RecordedReport report;
    Use use;
    std::size_t next_block = 0;
};

void RecordedReport::play(QPainter& painter, const QRectF& area, const PlotSpecification& plot) const {
    const auto found = plots.find(plot.id);
    if (found == plots.end()) return;
    painter.save();
    painter.translate(area.topLeft());
    painter.scale(area.width() / recorded_width, area.height() / recorded_height);
    painter.drawPicture(0, 0, found->second);
    painter.restore();
}

ReportRecorder::ReportRecorder(QObject* parent) : QObject(parent), jobs_(this, Execution::threads) {}

void ReportRecorder::record(std::shared_ptr<const Project> project, std::vector<EvaluatedAnalysis> analyses,
                            Use use) {
    busy_ = true;
    auto job = std::make_shared<Job>();
    job->number = ++number_;
    job->report.analyses = std::move(analyses);
    job->use = std::move(use);
    jobs_.push([this, job, project = std::move(project)]() -> JobQueue::Delivery {
        Problems known;  // those of assets stand in the problems list; an asset that cannot be made is not in
                         // the report
        const AssetLibrary assets = make_assets(*project, known);
        job->report.document = build_report(*project, assets, job->report.analyses);
        return [this, job] { record_next(job); };
    });
}

void ReportRecorder::record_next(const std::shared_ptr<Job>& job) {
    if (job->number != number_) return;
    RecordedReport& report = job->report;
    while (job->next_block < report.document.blocks.size()) {
        const auto* block = std::get_if<PlotBlock>(&report.document.blocks[job->next_block++]);
        if (!block) continue;
        QPainter painter(&report.plots[block->plot.id]);
        paint_plot(painter, QRectF(0.0, 0.0, recorded_width, recorded_height), block->plot, Theme::light());
        painter.end();
        QTimer::singleShot(0, this, [this, job] { record_next(job); });
        return;
    }
    jobs_.push([this, job]() -> JobQueue::Delivery {
        const JobQueue::Delivery done = job->use(job->report);
        return [this, job, done] {
            busy_ = job->number != number_;
            if (done) done();
        };
    });
}

}  // namespace covaria::ui
