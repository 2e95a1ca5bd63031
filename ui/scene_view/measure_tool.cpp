#include "ui/scene_view/measure_tool.h"

#include <QAction>
#include <QSignalBlocker>
#include <QToolBar>

#include "ui/scene_view/scene_view.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

MeasureTool::MeasureTool(SceneView& view, QObject* parent) : QObject(parent), view_(view) {
    distance_ = make_action("measure-distance", tr("Measure Distance"),
                            tr("Distance of two points, with its uncertainty (D)"), 2);
    angle_ = make_action("measure-angle", tr("Measure Angle"),
                         tr("Angle at the second of three points, with its uncertainty (A)"), 3);
    distance_->setShortcut(Qt::Key_D);
    angle_->setShortcut(Qt::Key_A);
    for (QAction* action : {distance_, angle_}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        view_.addAction(action);
    }
    connect(&view_, &SceneView::place_picked, this, &MeasureTool::add_place);
    connect(&view_, &SceneView::tool_left, this, &MeasureTool::put_away);
}

QAction* MeasureTool::make_action(const char* picture, const QString& text, const QString& tip,
                                  std::size_t places) {
    auto* action = new QAction(icon(QString::fromLatin1(picture)), text, this);
    action->setToolTip(tip);
    action->setCheckable(true);
    connect(action, &QAction::toggled, this, [this, action, places](bool on) {
        QAction* other = action == distance_ ? angle_ : distance_;
        const QSignalBlocker quiet(other);
        other->setChecked(false);
        wanted_ = on ? places : 0;
        ids_.clear();
        view_.set_picks_places(on);
        update();
    });
    return action;
}

void MeasureTool::add_to(QToolBar& toolbar) {
    toolbar.addAction(distance_);
    toolbar.addAction(angle_);
}

void MeasureTool::add_place(const QString& item_id) {
    const std::string id = to_std(item_id);
    if (!is_active() || !view_.scene() || !find_item(*view_.scene(), id)) return;
    if (ids_.size() == wanted_) ids_.clear();
    if (ids_.empty() || ids_.back() != id) ids_.push_back(id);
    update();
}

void MeasureTool::set_result(const ResultPointer& result) {
    result_ = result;
    update();
}

void MeasureTool::put_away() {
    distance_->setChecked(false);
    angle_->setChecked(false);
}

std::optional<Measurement> MeasureTool::measurement() const {
    if (!view_.scene() || ids_.size() != wanted_) return std::nullopt;
    return measure(*view_.scene(), result_.get(), ids_);
}

void MeasureTool::update() {
    const Scene* scene = view_.scene();
    if (scene) std::erase_if(ids_, [scene](const std::string& id) { return !find_item(*scene, id); });
    MeasureMark mark;
    if (scene)
        for (const std::string& id : ids_) mark.at.push_back(find_item(*scene, id)->position);
    if (const auto made = measurement()) mark.text = to_std(measured_value(*made, style(), scene->unit));
    view_.set_measure(std::move(mark));
    emit changed();
}

QString MeasureTool::words() const {
    if (!is_active()) return {};
    if (const auto made = measurement()) return measured_words(*made, style(), view_.scene()->unit);
    if (wanted_ == 2)
        return ids_.empty() ? tr("Distance: pick the first point. Esc puts the tool away.")
                            : tr("Distance: pick the second point.");
    if (ids_.empty()) return tr("Angle: pick a point on the first side. Esc puts the tool away.");
    return ids_.size() == 1 ? tr("Angle: pick the apex.") : tr("Angle: pick a point on the second side.");
}

}  // namespace covaria::ui
