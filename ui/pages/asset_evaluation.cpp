#include "ui/pages/asset_evaluation.h"

#include "core/project/workspace.h"
#include "ui/pages/data_table_html.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

struct Evaluation {
    QString html;
    std::vector<PlotSpecification> figures;
};

/// Tables and charts of one asset, or what is wrong with it.
Evaluation evaluate_asset(const Project& project, const std::string& id) {
    Problems problems;
    const AssetLibrary assets = make_assets(project, problems);
    const AssetLibrary::Entry* entry = assets.find(id);
    if (!entry) return {AssetEvaluation::tr("The asset has problems; they are listed below the scene."), {}};
    Evaluation found{html_of(entry->asset->evaluation()), entry->asset->figures()};
    if (found.html.isEmpty() && found.figures.empty())
        found.html = AssetEvaluation::tr("This asset is used as it is specified; nothing is evaluated.");
    return found;
}

}  // namespace

AssetEvaluation::AssetEvaluation(Document& document, std::string asset, QWidget* parent)
    : EvaluationView(Qt::Vertical, parent),
      document_(document),
      asset_(std::move(asset)),
      jobs_(this, Execution::threads) {
    setAccessibleName(tr("Evaluation of the asset"));
    connect(&document_, &Document::project_changed, this, &AssetEvaluation::refresh);
    refresh();
}

void AssetEvaluation::refresh() {
    const auto evaluate = [this, project = document_.snapshot(), id = asset_]() -> JobQueue::Delivery {
        return [this, found = evaluate_asset(*project, id)] { show_evaluation(found.html, found.figures); };
    };
    jobs_.push(evaluate,
               [this](const Error& error) { show_evaluation(to_qt(error.message).toHtmlEscaped(), {}); });
}

}  // namespace covaria::ui
