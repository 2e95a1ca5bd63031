// Export: report, tables and results of what has been evaluated, without holding up the window.
#pragma once

#include <QAction>
#include <QObject>

#include "core/report/report.h"
#include "ui/document/document.h"
#include "ui/export/report_export.h"
#include "ui/export/report_recorder.h"
#include "ui/main_window/dialogs.h"
#include "ui/run/analysis_runner.h"
#include "ui/run/job_queue.h"

class QMenu;

namespace covaria::ui {

class ExportActions : public QObject {
    Q_OBJECT
public:
    ExportActions(Document& document, AnalysisRunner& runner, Dialogs& dialogs, QObject* parent = nullptr);

    QMenu* make_menu(QWidget* parent);
    QAction* pdf_action;

    void ask_report(ReportFormat format);
    void ask_tables();
    void export_report_to(const QString& file, ReportFormat format);
    /// results.json and the CSV tables, into a folder.
    void export_results_to(const QString& folder);
    bool is_busy() const { return recorder_.is_busy(); }

signals:
    void message(const QString& text);
    void finished(const QString& file, const QString& problem);

private:
    QString suggested(const QString& ending) const;
    void finish(const QString& file, const QString& problem);

    Document& document_;
    AnalysisRunner& runner_;
    Dialogs& dialogs_;
    ReportRecorder recorder_;
    JobQueue jobs_;
};

}  // namespace covaria::ui
