#include "ui/pages/asset_evaluation.h"

#include "ui/pages/data_table_html.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int least_height = 420;  // px, for a table above a chart

struct Evaluation {
    QString html;
    std::vector<PlotSpecification> figures;
};

/// Tables and charts of one asset, or what is wrong with it.
Evaluation evaluate(const std::shared_ptr<const Asset>& asset) {
    if (!asset) return {AssetEvaluation::tr("The asset has problems; they are listed below the scene."), {}};
    Evaluation found{html_of(asset->evaluation()), core_plots(asset->figures())};
    if (found.html.isEmpty() && found.figures.empty())
        found.html = AssetEvaluation::tr("This asset is used as it is specified; nothing is evaluated.");
    return found;
}

}  // namespace

AssetEvaluation::AssetEvaluation(Document& document, std::string id, QWidget* parent)
    : EvaluationView(Qt::Vertical, parent),
      maker_(document.maker()),
      id_(std::move(id)),
      job_(Execution::threads) {
    setAccessibleName(tr("Evaluation of the asset"));
    setMinimumHeight(least_height);
    connect(&maker_, &ProjectMaker::made_changed, this, &AssetEvaluation::refresh);
    refresh();
}

void AssetEvaluation::refresh() {
    if (!maker_.made()) return;
    const AssetLibrary::Entry* entry = maker_.made()->assets().find(id_);
    const std::shared_ptr<const Asset> asset = entry ? entry->asset : nullptr;
    if (shown_ == asset && asset) return;
    shown_ = asset;
    job_.start(
        [this, asset](const std::stop_token&) -> JobQueue::Delivery {
            return [this, found = evaluate(asset)] { show_evaluation(found.html, found.figures); };
        },
        [this](const Error& error) { show_evaluation(to_qt(error.message).toHtmlEscaped(), {}); });
}

}  // namespace covaria::ui
