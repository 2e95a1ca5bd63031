#include "ui/pages/design_tab.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/document/document_writers.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/views/design_plots.h"
#include "core/views/design_results.h"
#include "ui/forms/finish_typing.h"
#include "ui/forms/form_labels.h"
#include "ui/models/number_words.h"
#include "ui/pages/data_table_html.h"
#include "ui/pages/empty_note.h"
#include "ui/pages/evaluation_view.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/elided_label.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

DesignTab::DesignTab(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner), selection_(selection) {
    make_head();
    view_ = new EvaluationView(Qt::Horizontal);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(head_);
    column->addWidget(view_, 1);
    what_to_do_ = new EmptyNote;
    column->addWidget(what_to_do_, 1);
    connect(&runner_.designs(), &DesignRunner::changed, this,
            [this](const QString& analysis, const QString& id) {
                if (analysis == selection_.analysis() && id == selection_.design()) refresh();
            });
    connect(&runner_.designs(), &DesignRunner::progress_changed, this,
            [this](const QString&, const RunProgress& progress) { show_progress(progress); });
    connect(&candidates_, &FileWatch::changed, &runner_.designs(), &DesignRunner::recheck);
    connect(&document_, &Document::project_changed, this, &DesignTab::refresh);
    connect(&selection_, &Selection::design_changed, this, &DesignTab::refresh);
    connect(&selection_, &Selection::analysis_changed, this, &DesignTab::refresh);
    refresh();
    show_result();
}

void DesignTab::make_head() {
    head_ = new QWidget;
    auto* row = new QHBoxLayout(head_);
    row->setContentsMargins(4, 2, 4, 2);
    list_ = new QComboBox;
    list_->setAccessibleName(tr("Design"));
    list_->setToolTip(tr("Design of this analysis"));
    narrow_if_need_be(*list_);
    const auto button = [](const QString& text, const char* name, const QString& tip) {
        auto* made = new QPushButton(text);
        made->setObjectName(QString::fromLatin1(name));
        made->setToolTip(tip);
        return made;
    };
    run_ = button(tr("Run Design"), "run_design_tab", tr("Searches for the best design"));
    stop_ = button(tr("Stop"), "stop_design", tr("Stops the search (Esc)"));
    edit_ = button(tr("Edit …"), "edit_design",
                   tr("Variables, rows and objective of the design, in the properties of the analysis"));
    take_over_ = button(tr("Take Over This Design"), "take_over_design",
                        tr("Puts the values and rows that were found into the project; can be undone"));
    state_ = new ElidedLabel;
    for (QWidget* each : std::initializer_list<QWidget*>{list_, run_, stop_, edit_, take_over_})
        row->addWidget(each);
    row->addWidget(state_, 1);
    connect(list_, &QComboBox::activated, this,
            [this](int index) { selection_.select_design(list_->itemData(index).toString()); });
    connect(run_, &QPushButton::clicked, this, [this] {
        finish_typing();
        if (design_of_project()) runner_.designs().run(selection_.analysis(), selection_.design());
    });
    connect(stop_, &QPushButton::clicked, &runner_.designs(), &DesignRunner::stop_all);
    connect(edit_, &QPushButton::clicked, this, [this] {
        const std::string analysis = to_std(selection_.analysis());
        const AnalysisEntry* entry = document_.project().find_analysis(analysis);
        if (entry && list_->count() == 0)
            selection_.select_design(
                to_qt(design_list().add(document_, analysis, new_design(document_.project(), *entry))));
        emit edit_wanted();
    });
    connect(take_over_, &QPushButton::clicked, this, &DesignTab::take_over_design);
}

const Design* DesignTab::design_of_project() const {
    return design_list().find(document_.project(), to_std(selection_.analysis()),
                              to_std(selection_.design()));
}

DesignStatus DesignTab::status() const {
    return runner_.designs().status(selection_.analysis(), selection_.design());
}

void DesignTab::refresh_list() {
    const AnalysisEntry* entry = document_.project().find_analysis(to_std(selection_.analysis()));
    const QSignalBlocker blocker(list_);
    list_->clear();
    for (std::size_t i = 0; entry && i < entry->designs.size(); ++i) {
        const Design& design = entry->designs[i];
        list_->addItem(to_qt(design.name.empty() ? design.id : design.name), to_qt(design.id));
    }
    if (entry && !entry->designs.empty() && !design_of_project())
        selection_.select_design(to_qt(entry->designs.front().id));
    list_->setCurrentIndex(list_->findData(selection_.design()));
    list_->setVisible(list_->count() > 0);
    edit_->setEnabled(entry != nullptr);
    edit_->setText(list_->count() > 0 ? tr("Edit …") : tr("Add Design …"));
}

void DesignTab::watch_candidates() {
    QString file;
    const Design* design = design_of_project();
    if (design && design->choose && !design->choose->candidates.empty())
        file = to_qt((document_.project().directory / design->choose->candidates).string());
    if (file != candidates_.file()) candidates_.watch(file);
}

void DesignTab::refresh() {
    refresh_list();
    watch_candidates();
    const DesignStatus now = status();
    const DesignPointer result = design_of_project() ? now.result : nullptr;
    const bool other = result != shown_ || now.is_current() != current_;
    shown_ = result;
    current_ = now.is_current();
    run_->setVisible(design_of_project() != nullptr && now.state != RunState::running);
    stop_->setVisible(now.state == RunState::running);
    take_over_->setVisible(shown_ != nullptr);
    take_over_->setEnabled(current_ && shown_ && shown_->found);
    state_->setText(state_words());
    state_->setToolTip(state_->text());
    if (other || !shown_) show_result();  // without a result it says what to do next
    if (other) emit shown_changed();
}

void DesignTab::show_result() {
    view_->setVisible(shown_ != nullptr);
    what_to_do_->setVisible(!shown_);
    what_to_do_->setText(
        design_of_project()
            ? tr("“%1” shows the best that can be done with what the design may choose.").arg(run_->text())
            : tr("A design finds where to stand and what to measure: add one with “%1”.").arg(edit_->text()));
    if (!shown_) return view_->show_evaluation({}, {});
    std::vector<PlotSpecification> plots = design_plots(*shown_, language_of_window());
    if (!current_)
        for (PlotSpecification& plot : plots) plot.title += to_std(tr(" – out of date"));
    view_->show_evaluation(html_of(readable_design_tables(*shown_)), std::move(plots));
}

void DesignTab::show_progress(const RunProgress& progress) {
    if (status().state != RunState::running) return;
    QString words = tr("%1 of %2 evaluations").arg(progress.trials_done).arg(progress.trials_planned);
    if (progress.best) words += tr(", best so far %1").arg(localized(format_significant(*progress.best, 5)));
    state_->setText(words);
}

QString DesignTab::state_words() const {
    const DesignStatus now = status();
    if (!design_of_project()) return {};
    if (now.state == RunState::running) return tr("searching …");
    if (now.state == RunState::failed) return tr("Failed: %1").arg(now.message);
    if (!now.result) return tr("Not searched yet.");
    const DesignResult& result = *now.result;
    QString words = tr("Nothing that was tried has a result.");
    if (result.found && result.cost)
        words =
            (result.rows.empty() ? tr("The cheapest reductions cost %1") : tr("The cheapest rows cost %1"))
                .arg(localized(format_significant(*result.cost, 4)));
    else if (result.found)
        words = core_text(result.objective_words) + QStringLiteral(" ") +
                localized(format_significant(result.objective, 4)) +
                (result.before ? tr(", before %1").arg(localized(format_significant(*result.before, 4)))
                               : QString()) +
                tr(" (law of propagation)");
    for (const DesignGoal& goal : result.goals)
        if (result.found && !goal.met())
            words += tr("; <b>the target of U(%1) is not met</b>")
                         .arg(to_qt(to_html(symbol_text(goal.output.symbol))));
    return now.is_current() ? words : tr("<b>Out of date</b>: shown for the project as it was. ") + words;
}

/// Takes the design over in one edit, made of the state that is looked at.
void DesignTab::take_over_design() {
    finish_typing();
    const DesignStatus now = status();
    const auto made = runner_.made();
    if (!now.is_current() || !made) return;
    Problems problems;
    const auto prepared =
        prepare_design(made, to_std(selection_.analysis()), to_std(selection_.design()), problems);
    if (!prepared) return state_->setText(to_qt(first_error(problems, "the design cannot be taken over")));
    auto taken = take_over(document_.project(), *prepared, *now.result);
    if (!taken) return state_->setText(to_qt(taken.error().message));
    document_.apply(tr("Take over design"), [&](Project& project) { project = *std::move(taken); });
}

}  // namespace covaria::ui
