// Evaluation of a model's set-up beside the results: residuals, redundancy, fits ... as tables
// and charts.
#pragma once

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/jobs/latest_job.h"
#include "ui/pages/evaluation_view.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui {

/// Shows the evaluation of the analysis looked at, computed in a worker thread. Models that have none need no
/// tab. A row about a reading leads to it, and may offer to leave it out.
class EvaluationTab : public EvaluationView {
    Q_OBJECT
public:
    EvaluationTab(Document& document, AnalysisRunner& runner, Selection& selection,
                  QWidget* parent = nullptr);

signals:
    /// Tells whether there is anything to show.
    void filled(bool any);
    /// A place in the project is wanted: a JSON pointer into it.
    void place_wanted(const QString& path);

private:
    void refresh();
    void follow(const QUrl& link);

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    std::shared_ptr<const MeasurementModel> shown_;
    LatestJob job_;
};

}  // namespace covaria::ui
