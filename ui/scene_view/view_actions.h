// The menu of views: standard ones, orthographic or perspective, what is hidden, and views saved with the
// analysis.
#pragma once

#include <QMenu>
#include <QObject>
#include <functional>
#include <memory>

#include "ui/document/document.h"

namespace covaria::ui {

class SceneView;

class ViewActions : public QObject {
    Q_OBJECT
public:
    ViewActions(Document& document, SceneView& view, QObject* parent);

    /// Sets the analysis whose views are offered and which gets new ones; empty: none.
    void set_analysis(const QString& id);
    QMenu& menu() { return *menu_; }
    /// The name of a view to save, with a suggestion; empty: none. A dialog unless a test replaces it.
    std::function<QString(const QString& suggestion)> ask_name;

private:
    void add_standard_views();
    void list_saved_views();
    void save_view();
    void remove_view(const std::string& name);
    /// Changes the views of the analysis in one step of undo.
    void edit(const QString& words, const std::function<void(std::vector<SavedView>&)>& change);
    const std::vector<SavedView>& views() const;

    Document& document_;
    SceneView& view_;
    QString analysis_;
    std::unique_ptr<QMenu> menu_;
    QMenu* removal_ = nullptr;
    QAction* orthographic_ = nullptr;
    QAction* save_ = nullptr;
    QAction* before_saved_ = nullptr;  ///< the separator above the saved views
    QList<QAction*> saved_;
    std::vector<SavedView> listed_;
};

}  // namespace covaria::ui
