#include "ui/pages/asset_uses.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "ui/document/project_edits.h"
#include "ui/pages/project_pane.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"

namespace covaria::ui {

AssetUses::AssetUses(Document& document, Selection& selection, std::string asset, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      asset_(std::move(asset)),
      column_(new QVBoxLayout(this)),
      job_(Execution::threads) {
    setObjectName(QStringLiteral("asset_uses"));
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(2);
    connect(&document_, &Document::project_changed, this, &AssetUses::refresh);
    refresh();
}

void AssetUses::read() {
    const AssetEntry* entry = document_.project().find_asset(asset_);
    if (!entry) return;
    job_.start(
        [this, entry = *entry](const std::stop_token&) -> JobQueue::Delivery {
            return [this, known = templates_with(entry)] { list(known); };
        },
        [](const Error&) {});
}

void AssetUses::list(const std::vector<const AnalysisTemplate*>& known) {
    for (const AnalysisTemplate* one : known) {
        auto* button = new QToolButton;
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setAutoRaise(true);
        button->setIcon(icon(QStringLiteral("add")));
        button->setText(core_text(one->title));
        button->setToolTip(core_text(one->question));
        connect(button, &QToolButton::clicked, this, [this, one] { add(*one); });
        column_->addWidget(button);
    }
    has_any_ = !known.empty();
    refresh();
}

/// Selects what was added once the click is over: these buttons go with the asset's page.
void AssetUses::add(const AnalysisTemplate& wanted) {
    QString why;
    const std::string id = add_from_template(document_, wanted, why);
    if (id.empty()) {
        column_->addWidget(new QLabel(ProjectPane::tr("The analysis was not added: %1").arg(why)));
        return;
    }
    QMetaObject::invokeMethod(
        &selection_,
        [&selection = selection_, id] {
            selection.select_entry({SetupOwner::analysis, id});
        },
        Qt::QueuedConnection);
}

void AssetUses::refresh() {
    const bool is_unused = dependants(document_.project(), {SetupOwner::asset, asset_}).isEmpty();
    if (is_unused && !std::exchange(is_read_, true)) read();
    emit offered(has_any_ && is_unused);
}

}  // namespace covaria::ui
