// Export: report, tables and results of what has been evaluated, without holding up the window.
#pragma once

#include <QAction>
#include <QObject>
#include <functional>

#include "core/report/report.h"
#include "core/writers/writer.h"
#include "ui/document/document.h"
#include "ui/export/report_export.h"
#include "ui/export/report_maker.h"
#include "ui/jobs/job_queue.h"
#include "ui/main_window/dialogs.h"
#include "ui/run/analysis_runner.h"

class QMenu;

namespace covaria::ui {

class ExportActions : public QObject {
    Q_OBJECT
public:
    ExportActions(Document& document, AnalysisRunner& runner, Dialogs& dialogs, QObject* parent = nullptr);
    QMenu* make_menu(QWidget* parent);
    QAction* pdf_action;
    QAction* certificate_action;
    QAction* sheet_action;
    QAction* document_action;  ///< stands in the toolbar and exports the document in view
    /// The shortcut goes to the action that exports this document.
    void follow_view(DocumentKind kind);

    void ask_document(DocumentKind kind, ReportFormat format);
    /// Asks for a certificate, and says first what ISO/IEC 17025 requires and is missing.
    void ask_certificate();
    void ask_tables();
    /// Asks for a file for other programs, by a writer of core/writers.
    void ask_for_others(const Writer& writer);
    void export_for_others(const Writer& writer, const QString& file);
    void export_document_to(const QString& file, DocumentKind kind, ReportFormat format = ReportFormat::pdf);
    /// Writes results.json and the CSV tables into a folder.
    void export_results_to(const QString& folder);
    bool is_busy() const { return maker_.is_busy(); }

signals:
    void message(const QString& text);
    /// The user would rather state first what the certificate lacks.
    void certificate_wanted();
    void finished(const QString& file, const QString& problem);

private:
    /// Calls `what` when no analysis runs any more: an export has final results.
    void when_finished(const std::function<void()>& what);
    void go_on();
    QString without_words(const std::vector<std::string>& analyses) const;
    QString suggested(const QString& ending) const;
    bool has_results_or_runs();
    void write_document(DocumentKind kind, const QString& file, ReportFormat format);
    void write_results(const QString& folder);
    void write_for_others(const Writer& writer, const QString& file);
    void finish(const QString& file, const QString& problem, const QString& without);

    Document& document_;
    AnalysisRunner& runner_;
    Dialogs& dialogs_;
    ReportMaker maker_;
    std::function<void()> waiting_;
    JobQueue jobs_;
};

}  // namespace covaria::ui
