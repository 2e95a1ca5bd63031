// An asset's own evaluation: its budget and observations, as tables and charts.
#pragma once

#include "ui/document/document.h"
#include "ui/jobs/latest_job.h"
#include "ui/pages/evaluation_view.h"

namespace covaria::ui {

/// Follows the made project; evaluated in a worker thread.
class AssetEvaluation : public EvaluationView {
    Q_OBJECT
public:
    AssetEvaluation(Document& document, std::string id, QWidget* parent = nullptr);

private:
    void refresh();

    ProjectMaker& maker_;
    std::string id_;
    std::shared_ptr<const Asset> shown_;
    LatestJob job_;
};

}  // namespace covaria::ui
