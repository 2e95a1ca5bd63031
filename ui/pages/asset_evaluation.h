// What an asset's own evaluation says: its budget and observations, as tables and charts.
#pragma once

#include "ui/document/document.h"
#include "ui/pages/evaluation_view.h"
#include "ui/run/job_queue.h"

namespace covaria::ui {

/// Follows the document; evaluated in a worker thread.
class AssetEvaluation : public EvaluationView {
    Q_OBJECT
public:
    AssetEvaluation(Document& document, std::string asset, QWidget* parent = nullptr);

private:
    void refresh();

    Document& document_;
    std::string asset_;
    JobQueue jobs_;
};

}  // namespace covaria::ui
