// Evaluation of a model's set-up beside the results: residuals, redundancy, fits ... as tables
// and charts.
#pragma once

#include "ui/document/selection.h"
#include "ui/jobs/latest_job.h"
#include "ui/pages/evaluation_view.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui {

/// Shows the evaluation of the analysis looked at, computed in a worker thread. Models that have none need no
/// tab.
class EvaluationTab : public EvaluationView {
    Q_OBJECT
public:
    EvaluationTab(AnalysisRunner& runner, Selection& selection, QWidget* parent = nullptr);

signals:
    /// Tells whether there is anything to show.
    void filled(bool any);

private:
    void refresh();

    AnalysisRunner& runner_;
    Selection& selection_;
    std::shared_ptr<const MeasurementModel> shown_;
    LatestJob job_;
};

}  // namespace covaria::ui
