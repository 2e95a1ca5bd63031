#include "ui/pages/evaluation_tab.h"

#include <QTextBrowser>
#include <QUrl>

#include "core/project/remedies.h"
#include "ui/document/setup_address.h"
#include "ui/pages/data_table_html.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

EvaluationTab::EvaluationTab(Document& document, AnalysisRunner& runner, Selection& selection,
                             QWidget* parent)
    : EvaluationView(Qt::Horizontal, parent),
      document_(document),
      runner_(runner),
      selection_(selection),
      job_(Execution::threads) {
    setAccessibleName(tr("Evaluation of the set-up"));
    const auto take = [this](const QString& id) {
        if (id == selection_.analysis()) refresh();
    };
    connect(&runner_, &AnalysisRunner::state_changed, this, take);
    connect(&runner_, &AnalysisRunner::result_changed, this, take);
    connect(&selection_, &Selection::analysis_changed, this, &EvaluationTab::refresh);
    connect(&text(), &QTextBrowser::anchorClicked, this, &EvaluationTab::follow);
}

void EvaluationTab::follow(const QUrl& link) {
    const SetupAddress entry{SetupOwner::analysis, to_std(selection_.analysis())};
    const QString place = to_qt(setup_path(document_.project(), entry)) + link.path();
    if (link.scheme() == QLatin1String("place")) emit place_wanted(place);
    if (link.scheme() != QLatin1String("choose")) return;
    const auto changed =
        mended(document_.project(), {{}, {{to_std(place), to_std(link.query(QUrl::FullyDecoded))}}});
    if (changed)
        document_.apply(tr("Change of a reading where its residual stands"),
                        [&](Project& project) { project = *changed; });
}

void EvaluationTab::refresh() {
    const auto prepared = runner_.status(selection_.analysis()).prepared;
    const std::shared_ptr<const MeasurementModel> model = prepared ? prepared->model : nullptr;
    if (model == shown_) return;
    shown_ = model;
    // The tab stays where it is while the analysis has a problem.
    if (!model) {
        job_.cancel();
        return show_evaluation({}, {});
    }
    const auto evaluate = [this, model](const std::stop_token&) -> JobQueue::Delivery {
        return [this, html = html_of(model->evaluation()), figures = core_plots(model->figures())] {
            show_evaluation(html, figures);
            emit filled(!html.isEmpty() || !figures.empty());
        };
    };
    job_.start(evaluate,
               [this](const Error& error) { show_evaluation(to_qt(error.message).toHtmlEscaped(), {}); });
}

}  // namespace covaria::ui
