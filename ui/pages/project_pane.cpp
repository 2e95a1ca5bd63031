#include "ui/pages/project_pane.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "core/kinds/registries.h"
#include "core/made/library.h"
#include "ui/document/project_edits.h"
#include "ui/forms/finish_typing.h"
#include "ui/pages/entry_delegate.h"
#include "ui/pages/library_menu.h"
#include "ui/theme/core_text.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int narrowest = 40, least_for_names = 96;  // px

bool is_typed_as_budget(const std::string& model) {
    const ModelDescriptor* descriptor = find_model(model);
    return descriptor && descriptor->schema.find(&FieldSpec::states_quantities);
}

}  // namespace

std::vector<const ModelDescriptor*> models_for_new_analyses() {
    std::vector<const ModelDescriptor*> models;
    for (const ModelDescriptor& model : model_registry()) models.push_back(&model);
    std::stable_partition(models.begin(), models.end(),
                          [](const ModelDescriptor* model) { return is_typed_as_budget(model->id); });
    return models;
}

ProjectPane::ProjectPane(Document& document, AnalysisRunner& runner, Selection& selection,
                         const PreferenceStore& preferences, QWidget* parent)
    : QTreeView(parent),
      document_(document),
      runner_(runner),
      selection_(selection),
      preferences_(preferences),
      model_(document, runner) {
    setAccessibleName(tr("Project"));
    setFrameShape(QFrame::NoFrame);
    setHeaderHidden(true);
    setEditTriggers(QAbstractItemView::EditKeyPressed);
    setItemDelegate(new EntryDelegate(this));
    setIndentation(0);
    setRootIsDecorated(false);
    setItemsExpandable(false);
    setMinimumWidth(narrowest);
    duplicate_action = new QAction(icon(QStringLiteral("duplicate")), tr("Dup&licate"), this);
    duplicate_action->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_D));
    rename_action = new QAction(icon(QStringLiteral("rename")), tr("Re&name"), this);
    rename_action->setShortcut(QKeySequence(Qt::Key_F2));
    delete_action = new QAction(icon(QStringLiteral("delete")), tr("&Delete …"), this);
    delete_action->setShortcut(QKeySequence::Delete);
    for (QAction* action : {duplicate_action, rename_action, delete_action}) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(action);
    }
    setModel(&model_);  // tells of the current entry at once, so the actions must be there
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::Fixed);  // a mark; its words are in the tooltip
    header()->setMinimumSectionSize(0);
    follow_font(*this, [this] { header()->resizeSection(1, fontMetrics().height() + 28); });
    plus_ = new QToolButton(this);
    plus_->setIcon(icon(QStringLiteral("add")));
    plus_->setAutoRaise(true);
    plus_->setFocusPolicy(Qt::NoFocus);  // the tool bar and the menu are reached by keys
    plus_->setPopupMode(QToolButton::InstantPopup);
    plus_->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    plus_->setToolTip(tr("Add an analysis or what it uses"));
    plus_->setAccessibleName(plus_->toolTip());
    plus_->setMenu(make_add_menu(plus_));
    setFirstColumnSpanned(ProjectTreeModel::project_row, {}, true);  // its title has no state
    expandAll();
    connect(duplicate_action, &QAction::triggered, this, &ProjectPane::duplicate_selected);
    connect(rename_action, &QAction::triggered, this, [this] { edit(currentIndex().siblingAtColumn(0)); });
    connect(delete_action, &QAction::triggered, this, &ProjectPane::delete_selected);
    connect(&selection_, &Selection::entry_changed, this, &ProjectPane::follow_selection);
    connect(&document_, &Document::project_replaced, this, &QTreeView::expandAll);
    connect(&model_, &QAbstractItemModel::rowsInserted, this, [this](const QModelIndex& above) {
        expand(above);
        show_filled_groups();
    });
    connect(&model_, &QAbstractItemModel::rowsRemoved, this, &ProjectPane::show_filled_groups);
    show_filled_groups();
    update_actions();
}

QMenu* ProjectPane::make_add_menu(QWidget* parent) {
    auto* menu = new QMenu(tr("&Add"), parent);
    menu->setIcon(icon(QStringLiteral("add")));
    menu->addSection(tr("Analysis"));
    for (const ModelDescriptor* model : models_for_new_analyses())
        menu->addAction(core_text(model->title), this, [this, id = model->id] { add_analysis(id); });
    menu->addSection(tr("What it uses"));
    for (const AssetDescriptor& asset : asset_registry())
        menu->addAction(core_text(asset.title), this, [this, kind = asset.kind] { add_asset(kind); });
    menu->addSeparator();
    menu->addAction(icon(QStringLiteral("layers")), tr("&Library and Templates …"), this,
                    &ProjectPane::library_wanted);
    menu->addMenu(new LibraryMenu(document_, selection_, menu));
    return menu;
}

void ProjectPane::add_asset(const std::string& kind) {
    selection_.select_entry({SetupOwner::asset, covaria::ui::add_asset(document_, kind)});
    emit entry_added();
}

void ProjectPane::add_analysis(const std::string& model) {
    if (!is_typed_as_budget(model))
        if (const AnalysisTemplate* prepared = template_of(model)) return add_from_template(*prepared);
    selection_.select_entry(
        {SetupOwner::analysis, covaria::ui::add_analysis(document_, model, preferences_.new_analysis())});
    emit entry_added();
}

void ProjectPane::add_from_template(const AnalysisTemplate& wanted) {
    QString why;
    const std::string id = covaria::ui::add_from_template(document_, wanted, why);
    if (id.empty()) return emit message(tr("The analysis was not added: %1").arg(why));
    selection_.select_entry({SetupOwner::analysis, id});
    emit entry_added();
}

void ProjectPane::add_copy(const AssetEntry& asset) {
    selection_.select_entry({SetupOwner::asset, covaria::ui::add_copy(document_, asset)});
    emit message(tr("“%1” is in the project now").arg(to_qt(asset.name)));
}

void ProjectPane::duplicate_selected() {
    const SetupAddress address = model_.address(currentIndex());
    if (!address.id.empty()) selection_.select_entry({address.owner, duplicate(document_, address)});
}

void ProjectPane::delete_selected() {
    const SetupAddress address = model_.address(currentIndex());
    if (address.id.empty()) return;
    const QString name = currentIndex().siblingAtColumn(0).data().toString();
    const QStringList users = dependants(document_.project(), address);
    QString question = tr("Delete “%1”?").arg(name);
    if (!users.isEmpty())
        question += tr("\n\nIt is used by: %1. They will have an error until they use something else.")
                        .arg(users.join(tr(", ")));
    if (!users.isEmpty() && confirm && !confirm(question, tr("Delete"))) return;
    remove(document_, address);
}

void ProjectPane::keep_in_library(const SetupAddress& address) {
    const AssetEntry* asset = document_.project().find_asset(address.id);
    if (!asset) return;
    const Result<void> kept = add_to_own_library(*asset);
    emit message(kept ? tr("“%1” is in your library now (Add > From the Library)").arg(to_qt(asset->name))
                      : to_qt(kept.error().message));
}

void ProjectPane::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTreeView::currentChanged(current, previous);
    const SetupAddress address = model_.address(current);
    if (exists(document_.project(), address)) selection_.select_entry(address);
    update_actions();
}

void ProjectPane::show_filled_groups() {
    for (int category = ProjectTreeModel::artefacts; category < ProjectTreeModel::category_count; ++category)
        setRowHidden(category, {}, model_.rowCount(model_.index(category, 0)) == 0);
}

/// Shows a column of icons where names have no room; names and states are then in the tooltips.
void ProjectPane::resizeEvent(QResizeEvent* event) {
    QTreeView::resizeEvent(event);
    const bool narrow = width() < least_for_names;
    setColumnHidden(ProjectTreeModel::state_column, narrow);
    const QRect first = visualRect(model_.index(ProjectTreeModel::project_row, 0));
    const QSize size = plus_->sizeHint();
    plus_->setVisible(!narrow);
    plus_->setGeometry(viewport()->width() - size.width() - 4, (first.height() - size.height()) / 2,
                       size.width(), size.height());
}

void ProjectPane::follow_selection() {
    const QModelIndex index = model_.index_of(selection_.entry());
    if (index.isValid() && index != currentIndex()) setCurrentIndex(index);
}

void ProjectPane::update_actions() {
    const SetupAddress address = model_.address(currentIndex());
    for (QAction* action : {duplicate_action, delete_action}) action->setEnabled(!address.id.empty());
    rename_action->setEnabled(exists(document_.project(), address));
}

void ProjectPane::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    fill_menu(menu, model_.address(indexAt(event->pos())));
    menu.exec(event->globalPos());
}

void ProjectPane::fill_menu(QMenu& menu, const SetupAddress& address) {
    menu.addMenu(make_add_menu(&menu));
    if (address.owner == SetupOwner::analysis && !address.id.empty())
        menu.addAction(icon(QStringLiteral("run")), tr("Run"), this, [this, address] {
            finish_typing();
            runner_.run(to_qt(address.id));
        });
    if (address.owner == SetupOwner::asset && !address.id.empty()) {
        menu.addAction(tr("Keep in My Library"), this, [this, address] { keep_in_library(address); });
        const QString asset = to_qt(address.id);
        const std::optional<bool> shown = is_in_scene ? is_in_scene(asset) : std::nullopt;
        QAction* show = menu.addAction(tr("Show in the Scene"), this,
                                       [this, asset](bool wanted) { emit scene_wanted(asset, wanted); });
        show->setCheckable(true);
        show->setChecked(shown.value_or(false));
        show->setEnabled(shown.has_value());
    }
    menu.addSeparator();
    menu.addActions({duplicate_action, rename_action, delete_action});
}

}  // namespace covaria::ui
