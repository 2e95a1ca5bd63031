// The analyses that an asset can be used in: what a user asks who has just added it.
#pragma once

#include <QWidget>

#include "core/made/analysis_templates.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/jobs/latest_job.h"

class QVBoxLayout;

namespace covaria::ui {

class AssetUses : public QWidget {
    Q_OBJECT
public:
    AssetUses(Document& document, Selection& selection, std::string asset, QWidget* parent = nullptr);

signals:
    /// Whether there is anything to choose from: not where something uses the asset already.
    void offered(bool any);

private:
    void read();
    void list(const std::vector<const AnalysisTemplate*>& known);
    void add(const AnalysisTemplate& wanted);
    void refresh();

    Document& document_;
    Selection& selection_;
    std::string asset_;
    bool is_read_ = false, has_any_ = false;
    QVBoxLayout* column_;
    LatestJob job_;  ///< reads the examples for the first asset that nothing uses
};

}  // namespace covaria::ui
