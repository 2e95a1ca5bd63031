#include "ui/main_window/export_actions.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>

#include "core/base/file_io.h"
#include "core/carried/report_data.h"
#include "core/made/certificate_gaps.h"
#include "core/result_files/result_files.h"
#include "core/writers/writers.h"
#include "ui/forms/finish_typing.h"
#include "ui/main_window/shortcut_tip.h"
#include "ui/pages/current_results.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

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

/// "Customer (7.8.2.1 e)"
QStringList missing_words(const MadeProject& made) {
    QStringList words;
    for (const CertificateGap& gap : certificate_gaps(made, certified_ids(made.project())))
        words << QStringLiteral("%1 (%2)").arg(to_qt(gap.what), QLatin1String(gap.clause));
    return words;
}

}  // namespace

ExportActions::ExportActions(Document& document, AnalysisRunner& runner, Dialogs& dialogs, QObject* parent)
    : QObject(parent),
      pdf_action(new QAction(icon(QStringLiteral("export")), tr("Report as &PDF …"), this)),
      certificate_action(new QAction(icon(QStringLiteral("export")), tr("&Certificate as PDF …"), this)),
      sheet_action(new QAction(icon(QStringLiteral("export")), tr("&Sheet as PDF …"), this)),
      document_action(new QAction(icon(QStringLiteral("export")), {}, this)),
      document_(document),
      runner_(runner),
      dialogs_(dialogs),
      jobs_(Execution::threads) {
    follow_view(DocumentKind::report);
    connect(document_action, &QAction::triggered, this, [this] {
        for (QAction* action : {pdf_action, certificate_action, sheet_action})
            if (!action->shortcut().isEmpty()) return action->trigger();
    });
    connect(pdf_action, &QAction::triggered, this,
            [this] { ask_document(DocumentKind::report, ReportFormat::pdf); });
    connect(certificate_action, &QAction::triggered, this, &ExportActions::ask_certificate);
    connect(sheet_action, &QAction::triggered, this,
            [this] { ask_document(DocumentKind::sheet, ReportFormat::pdf); });
    connect(&runner_, &AnalysisRunner::idle, this, [this] {
        if (!runner_.is_busy()) go_on();
    });
    connect(&document_, &Document::project_replaced, this, [this] { waiting_ = nullptr; });
}

QMenu* ExportActions::make_menu(QWidget* parent) {
    auto* menu = new QMenu(tr("Ex&port"), parent);
    menu->setIcon(icon(QStringLiteral("export")));
    menu->addAction(pdf_action);
    menu->addAction(tr("Report as &HTML …"), this,
                    [this] { ask_document(DocumentKind::report, ReportFormat::html); });
    menu->addAction(tr("Report as &Markdown …"), this,
                    [this] { ask_document(DocumentKind::report, ReportFormat::markdown); });
    menu->addSeparator();
    menu->addAction(certificate_action);
    menu->addAction(sheet_action);
    menu->addSeparator();
    menu->addAction(tr("&Results and Tables (JSON, CSV) …"), this, &ExportActions::ask_tables);
    for (const Writer& writer : writer_registry())
        menu->addAction(core_text(writer.title) + tr(" …"), this,
                        [this, &writer] { ask_for_others(writer); });
    return menu;
}

void ExportActions::follow_view(DocumentKind kind) {
    QAction* shown = kind == DocumentKind::certificate ? certificate_action
                     : kind == DocumentKind::sheet     ? sheet_action
                                                       : pdf_action;
    for (QAction* action : {pdf_action, certificate_action, sheet_action}) action->setShortcut({});
    shown->setShortcut(Qt::CTRL | Qt::Key_P);
    document_action->setText(shown->text());
    document_action->setToolTip(tip_with_shortcut(shown->text(), shown->shortcut()));
}

QString ExportActions::suggested(const QString& ending) const {
    return QDir(last_folder()).filePath(QFileInfo(document_.display_name()).completeBaseName() + ending);
}

/// Runs the analyses where there are no results yet: a document is to state some. False: nothing runs.
bool ExportActions::has_results_or_runs() {
    const auto has_results = [this] {
        return runner_.is_busy() || !current_results(document_.project(), runner_).empty();
    };
    if (has_results()) return true;
    runner_.run_all();
    if (has_results()) return true;
    dialogs_.show_message(tr("No results yet"),
                          tr("No analysis can be run: each one is incomplete or has errors."));
    return false;
}

void ExportActions::when_finished(const std::function<void()>& what) {
    finish_typing();
    waiting_ = what;
    if (runner_.is_busy())
        emit message(tr("The export waits until the analyses have run"));
    else
        go_on();
}

void ExportActions::go_on() {
    const auto what = std::exchange(waiting_, nullptr);
    if (what && has_results_or_runs()) what();
}

QString ExportActions::without_words(const std::vector<std::string>& analyses) const {
    const QStringList names = left_out(document_.project(), analyses, runner_);
    return names.isEmpty() ? QString() : tr(", without %1: not up to date").arg(names.join(tr(", ")));
}

void ExportActions::ask_document(DocumentKind kind, ReportFormat format) {
    finish_typing();
    if (!has_results_or_runs()) return;
    const QString ending = QString::fromLatin1(ending_of(format));
    const auto [title, name] = kind == DocumentKind::certificate
                                   ? std::pair(tr("Export Certificate"), QStringLiteral("-certificate"))
                               : kind == DocumentKind::sheet
                                   ? std::pair(tr("Export Sheet"), QStringLiteral("-sheet"))
                                   : std::pair(tr("Export Report"), QString());
    const QString file = dialogs_.file_to_save(title, suggested(name + ending), filter_of(format));
    if (file.isEmpty()) return;
    remember_folder_of(file);
    export_document_to(file.endsWith(ending) ? file : file + ending, kind, format);
}

void ExportActions::ask_certificate() {
    finish_typing();
    if (!has_results_or_runs()) return;
    const QStringList missing = missing_words(*MadeProject::make(document_.project(), runner_.made()));
    const QString question =
        tr("The certificate does not state what ISO/IEC 17025 requires of it:\n\n%1\n\n"
           "It says “not stated” in these places. They are fields of the project's page.")
            .arg(missing.join(QLatin1Char('\n')));
    if (!missing.isEmpty() && !dialogs_.confirm(question, tr("Export Anyway"))) {
        emit certificate_wanted();
        return;
    }
    ask_document(DocumentKind::certificate, ReportFormat::pdf);
}

void ExportActions::ask_tables() {
    finish_typing();
    if (!has_results_or_runs()) return;
    const QString file =
        dialogs_.file_to_save(tr("Export Results and Tables into the Folder of"),
                              QFileInfo(suggested({})).dir().filePath(QStringLiteral("results.json")),
                              tr("Results (results.json)"));
    if (file.isEmpty()) return;
    remember_folder_of(file);
    export_results_to(QFileInfo(file).path());
}

void ExportActions::ask_for_others(const Writer& writer) {
    finish_typing();
    if (!has_results_or_runs()) return;
    if (const Problems missing = writer.missing ? writer.missing(document_.project()) : Problems();
        missing.has_errors()) {
        dialogs_.show_message(tr("%1: what it must state is missing").arg(core_text(writer.title)),
                              to_qt(first_error(missing, "")));
        return;
    }
    const QString ending = to_qt(writer.ending);
    const QString file =
        dialogs_.file_to_save(tr("Export %1").arg(core_text(writer.title)), suggested(ending),
                              tr("%1 (*%2)").arg(core_text(writer.title), ending));
    if (file.isEmpty()) return;
    remember_folder_of(file);
    export_for_others(writer, file.endsWith(ending) ? file : file + ending);
}

void ExportActions::export_for_others(const Writer& writer, const QString& file) {
    when_finished([this, &writer, file] { write_for_others(writer, file); });
}

void ExportActions::export_document_to(const QString& file, DocumentKind kind, ReportFormat format) {
    when_finished([this, file, kind, format] { write_document(kind, file, format); });
}

void ExportActions::export_results_to(const QString& folder) {
    when_finished([this, folder] { write_results(folder); });
}

void ExportActions::write_document(DocumentKind kind, const QString& file, ReportFormat format) {
    if (is_busy()) {
        emit message(tr("A report is being written; wait until it is finished"));
        return;
    }
    const QString without = without_words(reported_analyses(document_.project()));
    emit message(tr("Writing %1 …").arg(QFileInfo(file).fileName()));
    ReportTarget target;
    target.folder = to_path(QFileInfo(file).path());
    target.name = to_std(QFileInfo(file).completeBaseName());
    target.formats = {format};
    const ReportMaker::Source source = document_source(kind, document_.project(), runner_);
    maker_.make(
        source,
        [this, file, target, source, without](const ReportDocument& report, const FigurePainters& painters,
                                              const std::stop_token& stop) mutable -> JobQueue::Delivery {
            if (target.formats.front() == ReportFormat::pdf)
                target.attached = report_data({*source.made, source.analyses, source.failed});
            const auto written = export_report(report, target, painters, stop);
            const QString problem = written ? QString() : to_qt(written.error().message);
            return [this, file, problem, without] { finish(file, problem, without); };
        },
        [this, file, without](const Error& error) { finish(file, to_qt(error.message), without); });
}

void ExportActions::write_results(const QString& folder) {
    std::vector<std::string> all;
    for (const AnalysisEntry& analysis : document_.project().analyses) all.push_back(analysis.id);
    const QString without = without_words(all);
    jobs_.push(
        [this, folder, without, analyses = current_results(document_.project(), runner_),
         failed = failed_results(document_.project(), runner_),
         made = runner_.made()]() -> JobQueue::Delivery {
            const auto written = write_result_files(to_path(folder), *made, analyses, {failed, {}});
            const QString problem = written ? QString() : to_qt(written.error().message);
            return [this, folder, problem, without] { finish(folder, problem, without); };
        },
        [this, folder, without](const Error& error) { finish(folder, to_qt(error.message), without); });
}

void ExportActions::write_for_others(const Writer& writer, const QString& file) {
    std::vector<std::string> all;
    for (const AnalysisEntry& analysis : document_.project().analyses) all.push_back(analysis.id);
    const QString without = without_words(all);
    jobs_.push(
        [this, &writer, file, without, analyses = current_results(document_.project(), runner_),
         made = runner_.made()]() -> JobQueue::Delivery {
            const auto written = writer.write({*made, analyses});
            QString problem = written ? QString() : to_qt(written.error().message);
            if (written)
                if (const auto saved = write_file_atomically(to_path(file), written->bytes); !saved)
                    problem = to_qt(saved.error().message);
            return [this, file, problem, without] { finish(file, problem, without); };
        },
        [this, file, without](const Error& error) { finish(file, to_qt(error.message), without); });
}

void ExportActions::finish(const QString& file, const QString& problem, const QString& without) {
    if (problem.isEmpty())
        emit message(tr("Wrote %1").arg(QDir::toNativeSeparators(file)) + without);
    else
        dialogs_.show_message(tr("The export failed"), problem);
    emit finished(file, problem);
}

}  // namespace covaria::ui
