#include "ui/pages/evaluation_tab.h"

#include "ui/pages/data_table_html.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

EvaluationTab::EvaluationTab(AnalysisRunner& runner, Selection& selection, QWidget* parent)
    : EvaluationView(Qt::Horizontal, parent),
      runner_(runner),
      selection_(selection),
      jobs_(this, Execution::threads) {
    setAccessibleName(tr("Evaluation of the set-up"));
    const auto take = [this](const QString& id) {
        if (id == selection_.analysis()) refresh();
    };
    connect(&runner_, &AnalysisRunner::state_changed, this, take);
    connect(&runner_, &AnalysisRunner::result_changed, this, take);
    connect(&selection_, &Selection::analysis_changed, this, &EvaluationTab::refresh);
}

void EvaluationTab::refresh() {
    const auto prepared = runner_.status(selection_.analysis()).prepared;
    if (prepared == shown_) return;
    shown_ = prepared;
    // The tab stays where it is while the analysis has a problem.
    if (!prepared) return show_evaluation({}, {});
    const auto evaluate = [this, prepared]() -> JobQueue::Delivery {
        const QString html = html_of(prepared->model->evaluation());
        return [this, prepared, html, figures = prepared->model->figures()] {
            if (prepared != shown_) return;
            show_evaluation(html, figures);
            emit filled(!html.isEmpty() || !figures.empty());
        };
    };
    jobs_.push(evaluate,
               [this](const Error& error) { show_evaluation(to_qt(error.message).toHtmlEscaped(), {}); });
}

}  // namespace covaria::ui
