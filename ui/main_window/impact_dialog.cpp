#include "ui/main_window/impact_dialog.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/base/file_io.h"
#include "core/impact/impact_document.h"
#include "core/result_files/csv_writer.h"
#include "ui/forms/impact_form.h"
#include "ui/pages/sortable_table.h"
#include "ui/theme/document_language.h"
#include "ui/theme/fonts.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int most_lines_of_failures = 8;

Result<Impact> find_impact(const ImpactWords& words, const RunControl& control) {
    auto question = question_of(words);
    if (!question) return fail(question.error());
    return impact_of(*question, control);
}

QStringList sentences_of(const Impact& impact) {
    QStringList said;
    for (const Message& sentence : impact_sentences(impact)) said << to_qt(sentence);
    return said;
}

/// Fills the list with what could not be evaluated and what follows; it is as high as it must be and hides
/// when it is empty.
void list_files(QListWidget& list, const Impact& impact) {
    list.clear();
    for (const ImpactFailure& failure : impact.failures)
        list.addItem(QStringLiteral("%1: %2").arg(to_qt(failure.file), to_qt(failure.cause)));
    for (const ImpactFollower& follower : impact.followers) list.addItem(to_qt(follower_words(follower)));
    list.setVisible(list.count() > 0);
    const int lines = std::min(2 * list.count(), most_lines_of_failures);  // two for each
    list.setFixedHeight(lines * (list.fontMetrics().lineSpacing() + 4) + 8);
}

}  // namespace

ImpactDialog::ImpactDialog(const Dialogs& dialogs, QWidget* parent)
    : QDialog(parent),
      dialogs_(dialogs),
      form_(new ImpactForm),
      table_(new SortableTable(model_, tr("impact"))),
      answer_(new QLabel),
      sentences_(new QLabel),
      failures_(new QListWidget),
      progress_(new QProgressBar),
      evaluate_(new QPushButton(tr("&Evaluate"))),
      stop_(new QPushButton(tr("&Stop"))),
      save_(new QPushButton(tr("Sa&ve"))),
      job_(Execution::threads) {
    setObjectName(QStringLiteral("impact"));
    setWindowTitle(tr("What Hangs on a Certificate"));
    table_->set_columns(QStringLiteral("impact"), ImpactTableModel::usually_hidden());
    answer_->setObjectName(QStringLiteral("impact_answer"));
    answer_->setFont(sized(answer_->font(), TextSize::title));
    for (QLabel* label : {answer_, sentences_}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    }
    failures_->setObjectName(QStringLiteral("impact_failures"));
    failures_->setAccessibleName(tr("Not evaluated, and what follows"));
    failures_->setWordWrap(true);
    failures_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QVBoxLayout(this);
    column->addWidget(form_);
    column->addLayout(make_run_row());
    column->addWidget(answer_);
    column->addWidget(sentences_);
    column->addWidget(table_, 1);
    column->addWidget(failures_);
    column->addLayout(make_foot());
    resize(1180, 680);
    connect(form_, &ImpactForm::changed, this, &ImpactDialog::refresh);
    connect(&form_->figures_button(), &QPushButton::clicked, this, [this] {
        const QString file = dialogs_.file_to_import(tr("New Figures"), last_folder(), tr("All files (*)"));
        activateWindow();  // which the file dialog gave to the window of the project
        if (!file.isEmpty()) form_->set_new_figures(file);
    });
    connect(&form_->place_button(), &QPushButton::clicked, this, [this] {
        const QString folder = dialogs_.folder_to_search(tr("Folder With Projects and Reports"));
        activateWindow();
        if (!folder.isEmpty()) form_->add_place(folder);
    });
    connect(table_, &SortableTable::row_activated, this,
            [this](int row) { emit file_wanted(to_qt(model_.file_of(row))); });
    connect(table_, &SortableTable::failed, this,
            [this](const QString& problem) { answer_->setText(problem); });
    end_run();
    show_impact({}, false);
}

QLayout* ImpactDialog::make_run_row() {
    evaluate_->setObjectName(QStringLiteral("impact_evaluate"));
    evaluate_->setDefault(true);
    progress_->setAccessibleName(tr("Files evaluated"));
    progress_->setTextVisible(false);
    auto* row = new QHBoxLayout;
    row->addWidget(evaluate_);
    row->addWidget(stop_);
    row->addWidget(progress_, 1);
    row->addStretch();
    connect(evaluate_, &QPushButton::clicked, this, &ImpactDialog::evaluate);
    connect(stop_, &QPushButton::clicked, this, &ImpactDialog::stop);
    return row;
}

QLayout* ImpactDialog::make_foot() {
    auto* menu = new QMenu(save_);
    fill_save_menu(*menu);
    save_->setMenu(menu);
    auto* close = new QPushButton(tr("Close"));
    close->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->addWidget(save_);
    row->addStretch();
    row->addWidget(close);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    return row;
}

void ImpactDialog::fill_save_menu(QMenu& menu) {
    of_results_ << menu.addAction(tr("&Document (PDF) …"), this, [this] {
        const QString file =
            ask_file(tr("Save the Impact"), QStringLiteral(".pdf"), tr("PDF document (*.pdf)"));
        if (!file.isEmpty()) write_document(file, ReportFormat::pdf);
    });
    of_results_ << menu.addAction(tr("Document (&HTML) …"), this, [this] {
        const QString file =
            ask_file(tr("Save the Impact"), QStringLiteral(".html"), tr("HTML page (*.html)"));
        if (!file.isEmpty()) write_document(file, ReportFormat::html);
    });
    of_results_ << menu.addAction(tr("&Table (CSV) …"), this, [this] {
        const QString file = ask_file(tr("Save the Table"), QStringLiteral(".csv"), tr("CSV table (*.csv)"));
        if (!file.isEmpty()) write_text(file, to_csv(impact_table(*impact_)));
    });
    menu.addAction(tr("&List of Files …"), this, [this] {
        const QString file = ask_file(tr("Save the List"), QStringLiteral(".txt"), tr("Text (*.txt)"));
        if (!file.isEmpty())
            write_text(file, file_list(is_evaluated_ ? impact_->to_amend() : impact_->using_it));
    });
}

void ImpactDialog::refresh() {
    const ImpactWords words = form_->words();
    evaluate_->setEnabled(!is_busy() && !words.old_figures.empty() && !words.folders.empty());
    save_->setEnabled(impact_ && !is_busy());
    evaluate_->setText(words.new_figures.empty() ? tr("&Find Who Used It") : tr("&Evaluate"));
}

void ImpactDialog::evaluate() {
    asked_ = form_->words();
    show_impact({}, false);  // what is shown is never that of another question
    answer_->setText(tr("Evaluating …"));
    const auto tell = [this](const Progress& now) {
        inbox_.post([this, now] {
            progress_->setRange(0, static_cast<int>(now.trials_planned));
            progress_->setValue(static_cast<int>(now.trials_done));
        });
    };
    job_.start(
        [this, tell, words = asked_](const std::stop_token& stop) -> JobQueue::Delivery {
            auto found = find_impact(words, {stop, tell, 0, nullptr});
            if (!found) return [this, error = found.error()] { show_failure(error); };
            return [this, is_evaluated = !words.new_figures.empty(),
                    impact = std::make_shared<const Impact>(*std::move(found))] {
                end_run();
                show_impact(impact, is_evaluated);
            };
        },
        [this](const Error& error) { show_failure(error); });
    progress_->setRange(0, 0);
    progress_->show();
    stop_->setEnabled(true);
    refresh();
}

void ImpactDialog::stop() {
    job_.cancel();
    end_run();
    answer_->setText(tr("Stopped."));
}

void ImpactDialog::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && is_busy()) return stop();
    QDialog::keyPressEvent(event);
}

void ImpactDialog::reject() {
    if (is_busy()) stop();
    QDialog::reject();
}

void ImpactDialog::end_run() {
    progress_->hide();
    stop_->setEnabled(false);
    refresh();
}

void ImpactDialog::show_failure(const Error& error) {
    end_run();
    show_impact({}, false);
    answer_->setText(to_qt(error.message));
}

void ImpactDialog::show_impact(std::shared_ptr<const Impact> impact, bool is_evaluated) {
    impact_ = std::move(impact);
    is_evaluated_ = is_evaluated;
    model_.set_impact(impact_, is_evaluated);
    QStringList said = impact_ ? sentences_of(*impact_) : QStringList();
    if (is_evaluated && asked_.is_first_order) said << tr("Both before and after by the law of propagation.");
    // The answer is how many results change, else who used it: the second sentence or the first.
    answer_->setText(impact_ ? said.takeAt(impact_->rows.empty() ? 0 : 1)
                             : tr("Which results change when the figures of a certificate do?"));
    sentences_->setText(said.join(QLatin1Char(' ')));
    sentences_->setVisible(!said.isEmpty());
    list_files(*failures_, impact_ ? *impact_ : Impact());
    for (QAction* action : of_results_) action->setEnabled(is_evaluated);
    refresh();
}

QString ImpactDialog::ask_file(const QString& title, const QString& ending, const QString& filter) {
    const QString file =
        dialogs_.file_to_save(title, QDir(last_folder()).filePath(tr("impact") + ending), filter);
    activateWindow();
    if (file.isEmpty()) return {};
    remember_folder_of(file);
    return file.endsWith(ending) ? file : file + ending;
}

void ImpactDialog::write_document(const QString& file, ReportFormat format) {
    ReportTarget target;
    target.folder = to_path(QFileInfo(file).path());
    target.name = to_std(QFileInfo(file).completeBaseName());
    target.formats = {format};
    job_.start(
        [this, file, target, words = asked_, impact = impact_,
         language = language_of_window()](const std::stop_token& stop) -> JobQueue::Delivery {
            const auto written = export_report(build_impact(words, *impact, language), target, {}, stop);
            return [this, file, written] { finish_writing(file, written); };
        },
        [this, file](const Error& error) { finish_writing(file, fail(error)); });
}

void ImpactDialog::write_text(const QString& file, const std::string& text) {
    finish_writing(file, write_file_atomically(to_path(file), text));
}

void ImpactDialog::finish_writing(const QString& file, const Result<void>& written) {
    refresh();
    if (!written) return dialogs_.show_message(tr("It could not be saved"), to_qt(written.error().message));
    sentences_->setText(tr("Wrote %1").arg(QDir::toNativeSeparators(file)));
    sentences_->show();
    emit finished_writing(file);
}

}  // namespace covaria::ui
