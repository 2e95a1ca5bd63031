// Export: report, tables and results of what has been evaluated, without holding up the window.
#pragma once

#include <QObject>
#include <QPicture>
#include <map>
#include <memory>

#include "core/report/report.h"
#include "ui/document/document.h"
#include "ui/export/report_export.h"
#include "ui/main_window/dialogs.h"
#include "ui/run/analysis_runner.h"
#include "ui/run/job_queue.h"

class QMenu;

namespace covaria::ui {

/// Charts belong to the window's thread: they are recorded there, one per turn of the event loop, and played
/// back in the worker that lays out and writes the report.
class ExportActions : public QObject {
    Q_OBJECT
public:
    ExportActions(Document& document, AnalysisRunner& runner, Dialogs& dialogs, QObject* parent = nullptr);

    QMenu* make_menu(QWidget* parent);

    void ask_report(ReportFormat format);
    void ask_tables();
    void export_report_to(const QString& file, ReportFormat format);
    /// results.json and the CSV tables, into a folder.
    void export_results_to(const QString& folder);
    bool is_busy() const { return busy_; }

signals:
    void message(const QString& text);
    void finished(const QString& file, const QString& problem);

private:
    struct Job;
    /// The current results of all analyses; empty if there are none yet.
    std::vector<EvaluatedAnalysis> evaluated() const;
    QString suggested(const QString& ending) const;
    void record_next_plot(const std::shared_ptr<Job>& job);
    void write_in_worker(const std::shared_ptr<Job>& job);
    void finish(const QString& file, const QString& problem);

    Document& document_;
    AnalysisRunner& runner_;
    Dialogs& dialogs_;
    bool busy_ = false;
    JobQueue jobs_;
};

}  // namespace covaria::ui
