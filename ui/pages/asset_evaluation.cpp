#include "ui/pages/asset_evaluation.h"

#include <QScrollBar>

#include "core/project/workspace.h"
#include "ui/pages/data_table_html.h"

namespace covaria::ui {
namespace {

/// The tables of one asset, or what is wrong with it.
QString evaluation_html(const Project& project, const std::string& id) {
    Problems problems;
    const AssetLibrary assets = make_assets(project, problems);
    const AssetLibrary::Entry* entry = assets.find(id);
    if (!entry) return AssetEvaluation::tr("The asset has problems; they are listed below the scene.");
    const QString html = html_of(entry->asset->evaluation());
    return html.isEmpty()
               ? AssetEvaluation::tr("This asset is used as it is specified; nothing is evaluated.")
               : html;
}

}  // namespace

AssetEvaluation::AssetEvaluation(Document& document, std::string asset, QWidget* parent)
    : QTextBrowser(parent), document_(document), asset_(std::move(asset)), jobs_(this, Execution::threads) {
    setFrameShape(QFrame::NoFrame);
    this->document()->setDocumentMargin(10);
    setAccessibleName(tr("Evaluation of the asset"));
    connect(&document_, &Document::project_changed, this, &AssetEvaluation::refresh);
    refresh();
}

void AssetEvaluation::refresh() {
    jobs_.push([this, project = document_.snapshot(), id = asset_]() -> JobQueue::Delivery {
        const QString html = evaluation_html(*project, id);
        return [this, html] {
            const int position = verticalScrollBar()->value();
            setHtml(html);
            verticalScrollBar()->setValue(position);
        };
    });
}

}  // namespace covaria::ui
