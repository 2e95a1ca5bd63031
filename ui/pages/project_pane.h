// The project tree with what can be done to its entries: add, duplicate, rename, delete, run.
#pragma once

#include <QTreeView>
#include <functional>
#include <optional>

#include "core/made/analysis_templates.h"
#include "ui/document/selection.h"
#include "ui/models/project_tree_model.h"
#include "ui/theme/preferences.h"

class QAction;
class QMenu;
class QToolButton;

namespace covaria::ui {

class ProjectPane : public QTreeView {
    Q_OBJECT
public:
    ProjectPane(Document& document, AnalysisRunner& runner, Selection& selection,
                const PreferenceStore& preferences, QWidget* parent = nullptr);

    /// Asked before something is deleted; the question names what depends on it.
    std::function<bool(const QString& question, const QString& action)> confirm;

    /// Whether the scene shows the parts of an asset; empty: it has none there.
    std::function<std::optional<bool>(const QString& asset)> is_in_scene;

    QAction* duplicate_action;
    QAction* rename_action;
    QAction* delete_action;
    /// Menu with one entry per registered kind.
    QMenu* make_add_menu(QWidget* parent);

    void add_asset(const std::string& kind);
    /// Adds an analysis from the model's first template, so that it has results at once; an empty one where
    /// there is no template, and where a budget is typed.
    void add_analysis(const std::string& model);
    void add_from_template(const AnalysisTemplate& wanted);
    void add_copy(const AssetEntry& asset);
    void duplicate_selected();
    void delete_selected();
    /// Copies an asset into the user's library.
    void keep_in_library(const SetupAddress& address);

    /// Adds the actions on an entry.
    void fill_menu(QMenu& menu, const SetupAddress& address);

signals:
    void library_wanted();
    void scene_wanted(const QString& asset, bool shown);
    /// A new entry is to be filled in.
    void entry_added();
    /// A text is to be told in passing.
    void message(const QString& text);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void show_filled_groups();
    void follow_selection();
    void update_actions();

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    const PreferenceStore& preferences_;
    ProjectTreeModel model_;
    QToolButton* plus_;  ///< at the right of the first row
};

/// Models for new analyses; the everyday one, whose budget is typed, comes first.
std::vector<const ModelDescriptor*> models_for_new_analyses();

}  // namespace covaria::ui
