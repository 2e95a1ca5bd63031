#include "ui/scene_view/view_actions.h"

#include <QInputDialog>
#include <algorithm>
#include <utility>

#include "ui/scene_view/scene_view.h"
#include "ui/scene_view/view_cube_painter.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

ViewActions::ViewActions(Document& document, SceneView& view, QObject* parent)
    : QObject(parent), document_(document), view_(view), menu_(std::make_unique<QMenu>(tr("&Scene"))) {
    ask_name = [this](const QString& suggestion) {
        return QInputDialog::getText(&view_, tr("Save View"), tr("Name of the view:"), QLineEdit::Normal,
                                     suggestion);
    };
    menu_->setToolTipsVisible(true);
    add_standard_views();
    menu_->addAction(icon(QStringLiteral("fit")), tr("Fit"), &view_, &SceneView::fit);
    orthographic_ = menu_->addAction(tr("&Orthographic"));
    orthographic_->setToolTip(tr("Parallel lines stay parallel, and the scale bar holds everywhere"));
    orthographic_->setCheckable(true);
    orthographic_->setChecked(true);
    connect(orthographic_, &QAction::triggered, this, [this](bool on) { view_.set_perspective(!on); });
    connect(&view_, &SceneView::perspective_changed, this,
            [this](bool perspective) { orthographic_->setChecked(!perspective); });
    menu_->addAction(tr("Show &All"), &view_, [this] { view_.show_all(); });
    before_saved_ = menu_->addSeparator();
    save_ = menu_->addAction(tr("&Save View …"), this, &ViewActions::save_view);
    removal_ = menu_->addMenu(tr("Remo&ve View"));
    connect(&document_, &Document::project_changed, this, &ViewActions::list_saved_views);
    list_saved_views();
}

void ViewActions::add_standard_views() {
    for (std::size_t i = 0; i < standard_view_count; ++i) {
        const auto view = static_cast<StandardView>(i);
        const QIcon picture = icon(QStringLiteral("view-") + to_qt(standard_view_names()[i]));
        QAction* action =
            menu_->addAction(picture, view_title(view), &view_, [this, view] { view_.set_view(view); });
        action->setShortcut(QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + static_cast<int>(i))));
    }
    menu_->addSeparator();
}

void ViewActions::set_analysis(const QString& id) {
    analysis_ = id;
    list_saved_views();
}

const std::vector<SavedView>& ViewActions::views() const {
    static const std::vector<SavedView> none;
    const AnalysisEntry* entry = document_.project().find_analysis(to_std(analysis_));
    return entry ? entry->views : none;
}

void ViewActions::list_saved_views() {
    save_->setEnabled(document_.project().find_analysis(to_std(analysis_)) != nullptr);
    removal_->setEnabled(!views().empty());
    if (listed_ == views()) return;
    listed_ = views();
    qDeleteAll(std::exchange(saved_, {}));
    removal_->clear();
    for (const SavedView& view : listed_) {
        auto* action = new QAction(to_qt(view.name).replace(QLatin1Char('&'), QStringLiteral("&&")), this);
        connect(action, &QAction::triggered, &view_, [this, view] { view_.show_view(view); });
        saved_ << action;
        removal_->addAction(action->text(), this, [this, name = view.name] { remove_view(name); });
    }
    menu_->insertActions(save_, saved_);
}

void ViewActions::save_view() {
    QString suggestion;
    for (int i = 1; suggestion.isEmpty() || find_view(views(), to_std(suggestion)); ++i)
        suggestion = tr("View %1").arg(i);
    const QString name = ask_name(suggestion).trimmed();
    const auto& taken = standard_view_names();
    if (name.isEmpty() || std::find(taken.begin(), taken.end(), to_std(name)) != taken.end()) return;
    edit(tr("Save View %1").arg(name), [&](std::vector<SavedView>& all) {
        const SavedView view = view_.saved(to_std(name));
        const auto same = std::find_if(all.begin(), all.end(),
                                       [&](const SavedView& other) { return other.name == view.name; });
        if (same == all.end())
            all.push_back(view);
        else
            *same = view;
    });
}

void ViewActions::remove_view(const std::string& name) {
    edit(tr("Remove View %1").arg(to_qt(name)), [&](std::vector<SavedView>& all) {
        std::erase_if(all, [&](const SavedView& view) { return view.name == name; });
    });
}

void ViewActions::edit(const QString& words, const std::function<void(std::vector<SavedView>&)>& change) {
    document_.apply(words, [&](Project& project) {
        for (AnalysisEntry& entry : project.analyses)
            if (entry.id == to_std(analysis_)) change(entry.views);
    });
}

}  // namespace covaria::ui
