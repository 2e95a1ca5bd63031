#include "ui/pages/inspector_head.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <algorithm>

#include "core/project/entry_names.h"
#include "ui/document/setup_address.h"
#include "ui/theme/elided_label.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/fonts.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// Entries of the tree in its order, to step through.
std::vector<SetupAddress> entries_of(const Project& project) {
    std::vector<SetupAddress> all{project_address};
    for (const AssetEntry& asset : project.assets) all.push_back({SetupOwner::asset, asset.id});
    for (const AnalysisEntry& analysis : project.analyses) all.push_back({SetupOwner::analysis, analysis.id});
    return all;
}

QToolButton* step_button(const QString& picture, const QString& words) {
    auto* button = new QToolButton;
    button->setIcon(icon(picture));
    button->setIconSize({16, 16});
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolTip(words);
    button->setAccessibleName(words);
    return button;
}

}  // namespace

InspectorHead::InspectorHead(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent), document_(document), selection_(selection), name_(new ElidedLabel) {
    name_->setObjectName(QStringLiteral("inspector_title"));
    follow_font(*this, [this] { name_->setFont(sized(font(), TextSize::title)); });
    before_ = step_button(QStringLiteral("previous"), tr("Entry before"));
    after_ = step_button(QStringLiteral("next"), tr("Entry after"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 4, 0, 4);
    row->setSpacing(2);
    row->addWidget(name_, 1);
    row->addWidget(before_);
    row->addWidget(after_);
    connect(before_, &QToolButton::clicked, this, [this] { step(-1); });
    connect(after_, &QToolButton::clicked, this, [this] { step(1); });
    connect(&selection_, &Selection::entry_changed, this, &InspectorHead::take_name);
    connect(&document_, &Document::project_changed, this, &InspectorHead::take_name);
    take_name();
}

void InspectorHead::take_name() {
    const Project& project = document_.project();
    const SetupAddress& entry = selection_.entry();
    QString words = tr("Properties");
    if (entry.owner == SetupOwner::project)
        words = tr("Project and documents");
    else if (exists(project, entry))
        words = to_qt(shown_name(project, entry.id, entry.owner == SetupOwner::analysis));
    name_->setText(words);
    name_->setToolTip(words);
    const std::vector<SetupAddress> all = entries_of(project);
    before_->setEnabled(all.front() != entry);
    after_->setEnabled(all.back() != entry);
}

void InspectorHead::step(int by) {
    const std::vector<SetupAddress> all = entries_of(document_.project());
    const auto now = std::find(all.begin(), all.end(), selection_.entry()) - all.begin() + by;
    if (now >= 0 && now < std::ssize(all)) selection_.select_entry(all[std::size_t(now)]);
}

}  // namespace covaria::ui
