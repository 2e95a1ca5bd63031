#include "ui/pages/compare_tab.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/made/load_project.h"
#include "core/project/entry_names.h"
#include "core/views/comparison_columns.h"
#include "ui/charts/chart_view.h"
#include "ui/forms/finish_typing.h"
#include "ui/forms/form_labels.h"
#include "ui/pages/empty_note.h"
#include "ui/pages/side_by_side.h"
#include "ui/pages/sortable_table.h"
#include "ui/run/result_words.h"
#include "ui/theme/document_language.h"
#include "ui/theme/elided_label.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// Words on how the kept result came about.
QString words_of(const KeptResult& kept) {
    if (!kept.trouble.isEmpty()) return kept.trouble;
    if (!kept.result) return CompareTab::tr("results that are computed again once the analysis has run");
    AnalysisStatus status;
    status.stage = ResultStage::complete;
    status.result = kept.result;
    return result_words(status);
}

/// Time at which results were kept, with the day if that is not today.
QString time_of(const KeptResult& kept) {
    const QDateTime at = kept.at();
    if (!at.isValid()) return to_qt(kept.state.at);
    const QLocale locale = QLocale::system();
    return at.date() == QDate::currentDate() ? locale.toString(at.time(), QLocale::ShortFormat)
                                             : locale.toString(at, QLocale::ShortFormat);
}

}  // namespace

CompareTab::CompareTab(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner), selection_(selection), kept_(runner.kept()) {
    ask_for_file = [this] {
        return QFileDialog::getOpenFileName(this, tr("Compare With Another Project"),
                                            from_path(document_.project().directory),
                                            tr("Covaria project (*.covaria)"));
    };
    ask_for_analysis = [this](const QStringList& analyses) {
        bool chosen = false;
        const QString name =
            QInputDialog::getItem(this, tr("Compare With Another Project"), tr("Analysis of that project:"),
                                  analyses, 0, false, &chosen);
        return chosen ? name : QString();
    };
    kept_.follow(document);
    make_actions();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(make_head());
    body_ = make_body();
    column->addWidget(body_, 1);
    what_to_do_ = new EmptyNote;
    column->addWidget(what_to_do_, 1);
    connect_parts();
    refresh();
}

void CompareTab::make_actions() {
    const auto action = [this](const QString& text, const char* name, const QString& tip) {
        auto* made = new QAction(text, this);
        made->setObjectName(QString::fromLatin1(name));
        made->setToolTip(tip);
        return made;
    };
    keep_ = action({}, "keep_before", {});  // `update_actions` gives its words
    go_back_ = action(tr("Go Back to Kept State"), "go_back",
                      tr("Makes the analysis, and what it uses, what they were when the results were kept, "
                         "and the coverage factor of the project; can be undone"));
    discard_ = action(tr("Discard Kept State"), "discard_kept",
                      tr("Forgets the kept results; the project stays as it is now"));
    go_back_->setIconText(tr("Go Back to Kept"));  // on the buttons
    discard_->setIconText(tr("Discard Kept"));
    others_ = new QMenu(tr("Compare With"), this);
    others_->menuAction()->setObjectName(QStringLiteral("compare_with"));
    others_->menuAction()->setToolTip(
        tr("Another analysis, of this project or of another one, stands in the place of kept results"));
    connect(others_, &QMenu::aboutToShow, this, &CompareTab::list_others);
    connect(keep_, &QAction::triggered, this, &CompareTab::keep);
    connect(go_back_, &QAction::triggered, this, &CompareTab::go_back);
    connect(discard_, &QAction::triggered, this, [this] { kept_.discard(selection_.analysis()); });
}

void CompareTab::add_to(QMenu& menu) {
    menu.addActions({keep_, others_->menuAction(), go_back_, discard_});
}

QWidget* CompareTab::make_head() {
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(4, 2, 4, 2);
    for (QAction* action : {keep_, others_->menuAction(), go_back_, discard_}) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        if (action->menu()) button->setPopupMode(QToolButton::InstantPopup);
        button->setObjectName(action->objectName() + QStringLiteral("_button"));
        button->setFocusPolicy(Qt::StrongFocus);
        row->addWidget(button);
    }
    state_ = new ElidedLabel;
    row->addWidget(state_, 1);
    row->addStretch();  // the buttons stay where they are without it
    return head;
}

QWidget* CompareTab::make_body() {
    results_ = new SortableTable(results_model_, tr("comparison"));
    results_->set_columns(
        QStringLiteral("comparison"),
        {QStringLiteral("Group"), QStringLiteral("Output quantity"), QStringLiteral("Change of estimate"),
         QStringLiteral("u before"), QStringLiteral("u after"), QStringLiteral("k before"),
         QStringLiteral("k after"), QStringLiteral("In")});
    budget_ = new SortableTable(budget_model_, tr("budget-changes"));
    budget_->set_columns(QStringLiteral("budget-changes"), {QStringLiteral("Origin")});
    chart_list_ = new QComboBox;
    chart_list_->setAccessibleName(tr("Chart"));
    may_be_narrow(*chart_list_);
    chart_list_->addItems({tr("Distributions"), tr("Changes of the budget")});
    chart_ = new ChartView;
    auto* charts = new QWidget;
    auto* column = new QVBoxLayout(charts);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(chart_list_);
    column->addWidget(chart_, 1);
    QSplitter* tables = one_above_other(results_, budget_);
    widen_to_content(*tables, *results_);
    QSplitter* body = side_by_side(tables, charts, 3, 2);
    for (SortableTable* table : {results_, budget_}) widen_to_content(*body, *table);
    return body;
}

void CompareTab::connect_parts() {
    const auto take = [this](const QString& id) {
        if (id == selection_.analysis()) refresh();
    };
    connect(&runner_, &AnalysisRunner::result_changed, this, take);
    connect(&runner_, &AnalysisRunner::state_changed, this, take);
    connect(&kept_, &KeptStates::changed, this, take);
    connect(&selection_, &Selection::analysis_changed, this, &CompareTab::refresh);
    connect(&selection_, &Selection::group_changed, this, &CompareTab::refresh);
    connect(&selection_, &Selection::output_changed, this, &CompareTab::show_output);
    connect(&document_, &Document::project_changed, this, &CompareTab::update_actions);
    connect(chart_list_, &QComboBox::currentIndexChanged, this, &CompareTab::show_chart);
    connect(results_, &SortableTable::row_selected, this, [this](int row) {
        const ComparedOutput& at = comparison_->outputs[results_model_.output_of(row)];
        if (at.after) selection_.select_output(int(*at.after));
    });
}

void CompareTab::keep() {
    finish_typing();
    if (!kept_.can_keep(selection_.analysis())) return;
    const bool replaced = kept_.find(selection_.analysis()) != nullptr;
    kept_.keep(selection_.analysis());
    emit message(replaced ? tr("The present results are kept in place of those kept before.")
                          : tr("The results are kept: the tab Compare shows them beside those to come."));
}

void CompareTab::list_others() {
    others_->clear();
    for (const AnalysisEntry& entry : document_.project().analyses) {
        if (entry.id == to_std(selection_.analysis())) continue;
        const QString name = to_qt(name_among(document_.project().analyses, entry));
        others_->addAction(QString(name).replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                           [this, id = entry.id, name] {
                               finish_typing();
                               compare_with(*document_.snapshot(), id, name);
                           });
    }
    if (!others_->isEmpty()) others_->addSeparator();
    others_->addAction(tr("Another Project …"), this, &CompareTab::compare_with_file);
}

void CompareTab::compare_with_file() {
    finish_typing();
    const QString file = ask_for_file();
    if (file.isEmpty()) return;
    const LoadedProject loaded = load_project(to_path(file));
    const std::vector<AnalysisEntry>& all = loaded.project.analyses;
    if (!loaded.is_whole) {
        emit message(to_qt(first_error(loaded.problems, {})));
        return;
    }
    QStringList names;
    for (const AnalysisEntry& entry : all) names << to_qt(name_among(all, entry));
    if (names.isEmpty()) {
        emit message(tr("%1 has no analysis.").arg(QFileInfo(file).fileName()));
        return;
    }
    const QString chosen = names.size() == 1 ? names.front() : ask_for_analysis(names);
    if (const qsizetype at = names.indexOf(chosen); at >= 0)
        compare_with(loaded.project, all[static_cast<std::size_t>(at)].id,
                     QFileInfo(file).fileName() + QStringLiteral(": ") + chosen);
}

void CompareTab::compare_with(const Project& project, const std::string& other, const QString& name) {
    kept_.compare_with(selection_.analysis(), project, other, name);
    emit message(tr("The tab Compare shows %1 as before.").arg(name));
}

/// Goes back in one edit: everything evaluated becomes what it was.
void CompareTab::go_back() {
    finish_typing();
    if (const KeptResult* kept = kept_.find(selection_.analysis()))
        document_.apply(tr("Go back to kept state"),
                        [before = kept->state](Project& project) { covaria::go_back(project, before); });
}

bool CompareTab::can_go_back() const {
    const KeptResult* kept = kept_.find(selection_.analysis());
    if (!kept || !kept->state.other.empty()) return false;
    Project before = document_.project();
    covaria::go_back(before, kept->state);
    return !(before == document_.project());
}

void CompareTab::update_actions() {
    const KeptResult* kept = kept_.find(selection_.analysis());
    keep_->setEnabled(kept_.can_keep(selection_.analysis()));
    keep_->setText(kept ? tr("Replace Kept State") : tr("Keep as Before"));
    keep_->setToolTip(kept
                          ? tr("Keeps the present results in place of those kept before, which are forgotten")
                          : tr("Keeps the present results of this analysis, to compare later ones with"));
    others_->menuAction()->setEnabled(!selection_.analysis().isEmpty());
    go_back_->setEnabled(can_go_back());
    discard_->setEnabled(kept != nullptr);
}

QString CompareTab::state_words() const {
    const QString& analysis = selection_.analysis();
    if (analysis.isEmpty()) return tr("Select an analysis to compare its results.");
    const KeptResult* kept = kept_.find(analysis);
    const AnalysisStatus& status = runner_.status(analysis);
    if (!kept && !kept_.can_keep(analysis))
        return tr("Run the analysis (F5), then keep its results with “%1”.").arg(keep_->text());
    if (!kept)
        return tr("Keep the present results with “%1” and edit, or choose another analysis by “%2”: before "
                  "and after stand here beside each other.")
            .arg(keep_->text(), tr("Compare With"));
    QString words = kept->state.other.empty()
                        ? tr("Before: %1, kept at %2. ").arg(words_of(*kept), time_of(*kept))
                        : tr("Before: %1 (%2), taken at %3. ")
                              .arg(to_qt(kept->state.other_name), words_of(*kept), time_of(*kept));
    if (!status.result) return words + tr("After: no results.");
    words += tr("After: %1").arg(result_words(status));
    const QString said = reservation(status);
    return said.isEmpty() ? words : words + QStringLiteral(" – <b>%1</b>").arg(said);
}

void CompareTab::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

/// Compares anew, but only while the comparison is looked at.
void CompareTab::refresh() {
    update_actions();
    state_->setText(state_words());
    state_->setToolTip(state_->text());
    const KeptResult* kept = kept_.find(selection_.analysis());
    const AnalysisStatus& status = runner_.status(selection_.analysis());
    const bool both = kept && kept->result && status.result;
    if (both && !isVisible()) return;
    comparison_ = both
                      ? std::make_shared<const ResultComparison>(compare_results(kept->result, status.result))
                      : nullptr;
    state_->setVisible(comparison_ != nullptr);
    body_->setVisible(comparison_ != nullptr);
    what_to_do_->setVisible(!comparison_);
    what_to_do_->setText(state_->text());
    current_ = status.is_of_present();
    const QString said = reservation(status);
    for (SortableTable* table : {results_, budget_}) table->set_remark(said);
    results_model_.set_comparison(comparison_, to_std(selection_.group()), current_);
    show_output();
}

std::optional<std::size_t> CompareTab::selected() const {
    if (!comparison_ || selection_.output() < 0) return std::nullopt;
    for (std::size_t i = 0; i < comparison_->outputs.size(); ++i)
        if (comparison_->outputs[i].after == static_cast<std::size_t>(selection_.output())) return i;
    return std::nullopt;
}

void CompareTab::show_output() {
    const auto output = selected();
    if (output) results_->select_row(results_model_.row_of(*output));
    budget_model_.set_comparison(output ? comparison_ : nullptr, output.value_or(0), current_);
    show_chart();
}

void CompareTab::show_chart() {
    const auto output = selected();
    if (!output) return chart_->set_plot({});
    const DocumentLanguage in = language_of_window();
    PlotSpecification plot = chart_list_->currentIndex() == 0
                                 ? compared_distributions_plot(*comparison_, *output, units_, in)
                                 : budget_changes_plot(*comparison_, *output, in);
    const QString said = reservation(runner_.status(selection_.analysis()));
    if (!said.isEmpty() && !plot.series.empty()) plot.title += " \u2013 " + to_std(said);
    chart_->set_plot(std::move(plot));
}

void CompareTab::set_units(const DisplayUnits& units) {
    units_ = units;
    results_model_.set_units(units);
    budget_model_.set_units(units);
    show_chart();
}

void CompareTab::set_digits(int digits) {
    results_model_.set_digits(digits);
    budget_model_.set_digits(digits);
}

}  // namespace covaria::ui
