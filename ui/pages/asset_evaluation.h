// What an asset's own evaluation says: its budget and observations, as tables.
#pragma once

#include <QTextBrowser>

#include "ui/document/document.h"
#include "ui/run/job_queue.h"

namespace covaria::ui {

/// Follows the document; evaluated in a worker thread.
class AssetEvaluation : public QTextBrowser {
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
