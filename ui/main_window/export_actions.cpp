#include "ui/main_window/export_actions.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QPainter>
#include <QTimer>

#include "core/project/project_file.h"
#include "ui/charts/chart_painter.h"
#include "ui/document/strings.h"
#include "ui/export/scene_pictures.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr QSizeF recorded_plot_size(640, 400);

const char* ending_of(ReportFormat format) {
    switch (format) {
        case ReportFormat::pdf:
            return ".pdf";
        case ReportFormat::html:
            return ".html";
        case ReportFormat::markdown:
            return ".md";
    }
    return "";
}

QString filter_of(ReportFormat format) {
    switch (format) {
        case ReportFormat::pdf:
            return ExportActions::tr("PDF document (*.pdf)");
        case ReportFormat::html:
            return ExportActions::tr("HTML page (*.html)");
        case ReportFormat::markdown:
            return ExportActions::tr("Markdown text (*.md)");
    }
    return {};
}

}  // namespace

struct ExportActions::Job {
    QString file;
    ReportFormat format;
    std::vector<EvaluatedAnalysis> analyses;
    ReportDocument document;
    std::size_t next_block = 0;
    std::map<std::string, QPicture> plots;

    void play(QPainter& painter, const QRectF& area, const PlotSpecification& plot) const {
        const auto found = plots.find(plot.id);
        if (found == plots.end()) return;
        painter.save();
        painter.translate(area.topLeft());
        painter.scale(area.width() / recorded_plot_size.width(), area.height() / recorded_plot_size.height());
        painter.drawPicture(0, 0, found->second);
        painter.restore();
    }
};

ExportActions::ExportActions(Document& document, AnalysisRunner& runner, Dialogs& dialogs, QObject* parent)
    : QObject(parent),
      document_(document),
      runner_(runner),
      dialogs_(dialogs),
      jobs_(this, Execution::threads) {}

QMenu* ExportActions::make_menu(QWidget* parent) {
    auto* menu = new QMenu(tr("&Export"), parent);
    menu->addAction(tr("Report as &PDF …"), QKeySequence(Qt::CTRL | Qt::Key_P), this,
                    [this] { ask_report(ReportFormat::pdf); });
    menu->addAction(tr("Report as &HTML …"), this, [this] { ask_report(ReportFormat::html); });
    menu->addAction(tr("Report as &Markdown …"), this, [this] { ask_report(ReportFormat::markdown); });
    menu->addSeparator();
    menu->addAction(tr("&Results and Tables …"), this, &ExportActions::ask_tables);
    return menu;
}

std::vector<EvaluatedAnalysis> ExportActions::evaluated() const {
    std::vector<EvaluatedAnalysis> all;
    for (const AnalysisEntry& analysis : document_.project().analyses) {
        const AnalysisStatus& status = runner_.status(to_qt(analysis.id));
        if (status.is_current()) all.push_back({status.result_of, status.result, status.warnings});
    }
    return all;
}

QString ExportActions::suggested(const QString& ending) const {
    const QString folder = document_.file().isEmpty() ? QDir::homePath() : QFileInfo(document_.file()).path();
    return QDir(folder).filePath(QFileInfo(document_.display_name()).completeBaseName() + ending);
}

void ExportActions::ask_report(ReportFormat format) {
    if (evaluated().empty()) {
        dialogs_.show_message(tr("Nothing to report yet"),
                              tr("No analysis is up to date. Run one first (F5)."));
        return;
    }
    const QString ending = QString::fromLatin1(ending_of(format));
    const QString file = dialogs_.file_to_save(tr("Export Report"), suggested(ending), filter_of(format));
    if (!file.isEmpty()) export_report_to(file.endsWith(ending) ? file : file + ending, format);
}

void ExportActions::ask_tables() {
    if (evaluated().empty()) {
        dialogs_.show_message(tr("No results yet"), tr("No analysis is up to date. Run one first (F5)."));
        return;
    }
    const QString file =
        dialogs_.file_to_save(tr("Export Results and Tables into the Folder of"),
                              QFileInfo(suggested({})).dir().filePath(QStringLiteral("results.json")),
                              tr("Results (results.json)"));
    if (!file.isEmpty()) export_results_to(QFileInfo(file).path());
}

void ExportActions::export_report_to(const QString& file, ReportFormat format) {
    if (busy_) {
        emit message(tr("A report is being written; wait until it is finished"));
        return;
    }
    busy_ = true;
    emit message(tr("Writing %1 …").arg(QFileInfo(file).fileName()));
    auto job = std::make_shared<Job>();
    job->file = file;
    job->format = format;
    job->analyses = evaluated();
    jobs_.push([this, job, project = document_.snapshot()]() -> JobQueue::Delivery {
        Problems ignored;  // those of assets are in the problems list; unusable assets are not in the report
        const AssetLibrary assets = make_assets(*project, ignored);
        job->document = build_report(*project, assets, job->analyses);
        return [this, job] { record_next_plot(job); };
    });
}

void ExportActions::record_next_plot(const std::shared_ptr<Job>& job) {
    while (job->next_block < job->document.blocks.size()) {
        const auto* block = std::get_if<PlotBlock>(&job->document.blocks[job->next_block++]);
        if (!block) continue;
        QPainter painter(&job->plots[block->plot.id]);
        paint_plot(painter, QRectF(QPointF(), recorded_plot_size), block->plot, Theme::light());
        painter.end();
        QTimer::singleShot(0, this, [this, job] { record_next_plot(job); });
        return;
    }
    write_in_worker(job);
}

void ExportActions::write_in_worker(const std::shared_ptr<Job>& job) {
    jobs_.push([this, job]() -> JobQueue::Delivery {
        ScenePictures scenes(job->analyses);
        FigurePainters painters;
        painters.paint_plot = [&](QPainter& painter, const QRectF& area, const PlotSpecification& plot) {
            job->play(painter, area, plot);
        };
        painters.render_scene = [&](const SceneBlock& block, QSize size) {
            return scenes.render(block, size);
        };
        ReportTarget target;
        target.folder = to_path(QFileInfo(job->file).path());
        target.name = to_std(QFileInfo(job->file).completeBaseName());
        target.formats = {job->format};
        const auto written = export_report(job->document, target, painters);
        const QString problem = written ? QString() : to_qt(written.error().message);
        return [this, file = job->file, problem] { finish(file, problem); };
    });
}

void ExportActions::export_results_to(const QString& folder) {
    jobs_.push(
        [this, folder, analyses = evaluated(), project = document_.snapshot()]() -> JobQueue::Delivery {
            const std::filesystem::path place = to_path(folder);
            auto written = write_file_atomically(place / "results.json", results_json(*project, analyses));
            for (const EvaluatedAnalysis& one : analyses)
                for (const DataTable& table : result_tables(one))
                    if (written)
                        written = write_file_atomically(place / (one.analysis->id + "-" + table.id + ".csv"),
                                                        to_csv(table));
            const QString problem = written ? QString() : to_qt(written.error().message);
            return [this, folder, problem] { finish(folder, problem); };
        });
}

void ExportActions::finish(const QString& file, const QString& problem) {
    busy_ = false;
    if (problem.isEmpty())
        emit message(tr("Wrote %1").arg(QDir::toNativeSeparators(file)));
    else
        dialogs_.show_message(tr("The export failed"), problem);
    emit finished(file, problem);
}

}  // namespace covaria::ui
