#include "ui/scene_view/scene_view.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/text/round_numbers.h"
#include "ui/scene_view/handle_painter.h"
#include "ui/scene_view/scene_keys.h"
#include "ui/scene_view/view_cube_painter.h"
#include "ui/theme/strings.h"
#include "viz/scene/pick.h"
#include "viz/scene/saved_camera.h"
#include "viz/scene/trial_pick.h"

namespace covaria::ui {
namespace {

constexpr qint64 least_pause_between_moves = 25;  // ms
constexpr double reach_of_dot = 8.0;              // around a dot of a cloud
constexpr double reach_of_pointer = 14.0;         // pixels around an item in which it can be grasped
constexpr double reach_of_arrow = 6.0;
constexpr double zoom_per_key = 1.15;
constexpr double pixels_per_snap = 12.0;  // about; a round number of the unit
constexpr double degrees_per_snap = 5.0;
constexpr QSize saved_picture_size(2560, 1600);

}  // namespace

SceneView::SceneView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setAccessibleName(tr("3D scene"));
    setAccessibleDescription(tr(
        "Arrow keys turn the scene, plus and minus zoom, F fits, 1 to 7 are standard views, H hides what is "
        "selected, I shows it alone, Shift+H shows all; points and instruments can be dragged to another "
        "place"));
    connect(&service_, &RenderService::rendered, this, &SceneView::take_image);
    connect(&service_, &RenderService::picked, this, [this](const QString& id) {
        select(id);
        emit item_picked(id);
    });
    connect(&service_, &RenderService::failed, this, [this](const QString& message) {
        failure_ = message;
        update();
    });
    connect(&service_, &RenderService::picture_made, this, &SceneView::finish_save);
}

SceneView::~SceneView() = default;

void SceneView::take_image(const QImage& image, const Camera& camera) {
    const bool other = camera.perspective != camera_.perspective;
    image_ = image;
    camera_ = camera;
    failure_.clear();
    update();
    if (other) emit perspective_changed(camera.perspective);
}

void SceneView::show_scene(std::shared_ptr<const Scene> scene) {
    whole_ = std::move(scene);
    send_scene();
}

void SceneView::set_visibility(const Visibility& visibility) {
    if (visibility == visibility_) return;
    visibility_ = visibility;
    send_scene();
}

void SceneView::show_all() {
    const bool was_alone = !visibility_.only.empty();
    set_visibility({});
    if (was_alone) fit();  // it was framed
}

std::optional<bool> SceneView::shows_asset(const QString& asset) const {
    return whole_ ? covaria::shows_asset(*whole_, *scene_, to_std(asset)) : std::nullopt;
}

void SceneView::show_asset(const QString& asset, bool shown) {
    if (whole_) set_visibility(with_asset(visibility_, *whole_, to_std(asset), shown));
}

void SceneView::set_section(const std::optional<SectionPlane>& section, bool moving) {
    if (std::exchange(section_, section) != section)
        send_scene(moving ? RenderQuality::moving : RenderQuality::full);
}

void SceneView::send_scene(RenderQuality quality) {
    scene_ = whole_;
    if (whole_ && (section_ || !visibility_.shows_all())) {
        Scene shown = visible_part(*whole_, visibility_);
        shown.section = section_;
        scene_ = std::make_shared<const Scene>(std::move(shown));
    }
    if (scene_)
        service_.post(
            [shown = scene_, needs_fit = framing_.next(scene_, framed_, moved_.has_value()),
             reserved = pixels_of_cube(),
             first = std::exchange(starts_over_, false)](SceneRenderer& renderer) {
                renderer.set_scene(*shown);
                renderer.set_reserved(reserved);
                if (first)
                    renderer.set_view(StandardView::iso);
                else if (needs_fit(renderer.camera(), renderer.size()))
                    renderer.fit();
            },
            moved_ ? RenderQuality::moving : quality);
    update();
}

void SceneView::set_palette_kind(ScenePalette palette) {
    palette_ = palette;
    service_.post([palette](SceneRenderer& renderer) { renderer.set_palette(palette); });
}

void SceneView::set_layers(const LayerVisibility& layers) {
    layers_ = layers;
    service_.post([layers](SceneRenderer& renderer) { renderer.set_layers(layers); });
}

void SceneView::set_view(StandardView view) {
    framed_ = true;
    service_.post([view](SceneRenderer& renderer) { renderer.set_view(view); });
}

void SceneView::set_perspective(bool perspective) {
    service_.post([perspective, framed = framed_](SceneRenderer& renderer) {
        renderer.set_perspective(perspective);
        if (framed && renderer.scene().size > 0) renderer.fit();
    });
}

void SceneView::show_view(const SavedView& view) {
    framed_ = false;
    set_visibility(visibility_of(view));
    service_.post(
        [camera = camera_of(view, picture_size())](SceneRenderer& renderer) { renderer.set_camera(camera); });
}

SavedView SceneView::saved(const std::string& name) const {
    return saved_view(name, camera_, picture_size(), visibility_);
}

void SceneView::fit() {
    framed_ = true;
    service_.post([](SceneRenderer& renderer) { renderer.fit(); });
}

void SceneView::start_over() {
    starts_over_ = framed_ = true;
    framing_ = {};
    visibility_ = {};
    if (camera_.perspective) set_perspective(false);
    select({});
}

void SceneView::select(const QString& item_id) {
    if (item_id == selected_) return;
    selected_ = item_id;
    service_.post([id = item_id.toStdString()](SceneRenderer& renderer) { renderer.set_selected(id); });
}

void SceneView::set_picks_places(bool picks) {
    picks_places_ = picks;
    setCursor(picks ? Qt::CrossCursor : Qt::ArrowCursor);
}

void SceneView::set_measure(MeasureMark mark) {
    service_.post([mark = std::move(mark)](SceneRenderer& renderer) { renderer.set_measure(mark); });
}

void SceneView::set_covered(int height) {
    if (std::exchange(covered_, height) == height) return;
    service_.post(
        [pixels = height * devicePixelRatioF()](SceneRenderer& renderer) { renderer.set_covered(pixels); });
}

void SceneView::set_empty_text(const QString& text) {
    empty_text_ = text;
    update();
}

void SceneView::copy_picture() {
    if (!image_.isNull()) QGuiApplication::clipboard()->setImage(image_);
}

void SceneView::save_picture(const QString& file, QSize size) {
    file_to_save_ = file;
    service_.make_picture(size);
}

void SceneView::finish_save(const QImage& image) {
    const bool saved = image.save(file_to_save_);
    emit picture_saved(file_to_save_,
                       saved ? QString() : tr("The picture could not be written to %1").arg(file_to_save_));
}

void SceneView::forget_trial() {
    if (std::exchange(picked_trial_, std::nullopt)) update();
}

void SceneView::post_framing(RenderService::Step step) {
    framed_ = false;
    post_moving(std::move(step));
}

void SceneView::send_size() {
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(size()) * ratio).toSize();
    post_moving(
        [pixels, ratio, reserved = pixels_of_cube(), framed = framed_ && !moved_](SceneRenderer& renderer) {
            renderer.set_size(pixels.width(), pixels.height());
            renderer.set_pixel_ratio(ratio);
            renderer.set_reserved(reserved);
            if (framed && renderer.scene().size > 0) renderer.fit();
        });
}

void SceneView::resizeEvent(QResizeEvent*) {
    send_size();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    pressed_at_ = last_at_ = event->position();
    button_ = event->button();
    dragged_ = false;
    if (button_ == Qt::LeftButton) moved_ = handle_under(event->position());
    if (!moved_) return;
    const Pixel at = project(camera_, picture_size(), moved_->item.position);
    grip_ = QPointF(at.x, at.y) - event->position() * devicePixelRatioF();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    if (!pressed_at_) return follow_pointer(event->position());
    if (!dragged_ && (event->position() - *pressed_at_).manhattanLength() < 4) return;
    if (moved_ && !dragged_) {
        emit drag_started();
        select(QString::fromStdString(moved_->item.id));
    }
    dragged_ = true;
    if (moved_) {
        // A mouse reports more often than results can follow.
        if (since_move_.isValid() && since_move_.elapsed() < least_pause_between_moves) return;
        since_move_.start();
        return bring_item_to(event->position(), event->modifiers());
    }
    drag_by(event->position() - last_at_);
    last_at_ = event->position();
}

/// Writes the name and the frame of an item while the pointer is at it.
void SceneView::point_at(const QString& item) {
    if (item == std::exchange(pointed_item_, item)) return;
    service_.post([id = to_std(item)](SceneRenderer& renderer) { renderer.set_pointed(id); });
}

void SceneView::leaveEvent(QEvent*) {
    point_at({});
}

/// The cursor says what a click would do.
void SceneView::follow_pointer(QPointF position) {
    point_at(item_under(position));
    if (const auto face = face_under(position); face != std::exchange(pointed_, face)) update();
    if (pointed_) return setCursor(Qt::PointingHandCursor);
    if (picks_places_) return setCursor(place_under(position) ? Qt::PointingHandCursor : Qt::CrossCursor);
    const auto handle = handle_under(position);
    const QString near = handle ? to_qt(handle->item.id) : is_near(reached_, position) ? reached_ : QString();
    const int axis = handle ? handle->axis : -1;
    setToolTip(handle ? handle_words(*handle, camera_) : QString());
    if (near != std::exchange(reached_, near) || axis != std::exchange(grasped_axis_, axis)) update();
    setCursor(!handle ? Qt::ArrowCursor : handle->turns() ? Qt::OpenHandCursor : Qt::SizeAllCursor);
}

std::optional<std::string> SceneView::place_under(QPointF position) const {
    if (!scene_ || image_.isNull()) return std::nullopt;
    const QPointF at = position * devicePixelRatioF();
    return place_at(
        *scene_, camera_, picture_size(), {at.x(), at.y()}, [this](Layer layer) { return layers_[layer]; },
        reach_of_pointer * devicePixelRatioF());
}

/// The trial whose dot is under the pointer; none where the pointer is at the point of the cloud itself.
std::optional<std::uint64_t> SceneView::trial_under(QPointF position) const {
    if (!scene_ || image_.isNull() || picks_places_) return std::nullopt;
    const Pixel pixel = pixel_at(position);
    for (const ScenePoint& point : scene_->points) {
        const Pixel at = project(camera_, picture_size(), point.item.position);
        if (std::hypot(at.x - pixel.x, at.y - pixel.y) < reach_of_dot * devicePixelRatioF())
            return std::nullopt;
    }
    return trial_at(
        *scene_, camera_, picture_size(), pixel_at(position), [this](Layer layer) { return layers_[layer]; },
        reach_of_dot * devicePixelRatioF());
}

QRectF SceneView::place_of_cube() const {
    return cube_place(size());
}

ScreenRect SceneView::pixels_of_cube() const {
    const QRectF place = place_of_cube();
    const double ratio = devicePixelRatioF();
    return {ratio * place.x(), ratio * place.y(), ratio * place.width(), ratio * place.height()};
}

std::vector<CubeFace> SceneView::cube() const {
    return scene_ && scene_->size > 0 ? cube_in(place_of_cube(), camera_) : std::vector<CubeFace>{};
}

std::optional<StandardView> SceneView::face_under(QPointF position) const {
    return face_at(cube(), {position.x(), position.y()});
}

PictureSize SceneView::picture_size() const {
    return {image_.width(), image_.height()};
}

Pixel SceneView::pixel_at(QPointF position) const {
    const QPointF at = position * devicePixelRatioF();
    return {at.x(), at.y()};
}

std::optional<Handle> SceneView::handle_under(QPointF position) const {
    if (picks_places_ || !scene_ || image_.isNull() || face_under(position)) return std::nullopt;
    const double ratio = devicePixelRatioF();
    auto handle = handle_at(
        *scene_, camera_, picture_size(), pixel_at(position), [this](Layer layer) { return layers_[layer]; },
        selected_.toStdString(), reach_of_pointer * ratio);
    if (handle && (handle->turns() || is_near(to_qt(handle->item.id), position, reach_of_pointer / 2)))
        return handle;
    const auto arrow = arrow_at(*scene_, camera_, picture_size(), pixel_at(position),
                                to_std(item_with_handles()), length_of_arrow * ratio, reach_of_arrow * ratio);
    return arrow ? arrow : handle;
}

bool SceneView::is_near(const QString& item, QPointF position, double reach) const {
    const SceneItem* found = scene_ ? find_item(*scene_, to_std(item)) : nullptr;
    if (!found) return false;
    const Pixel at = project(camera_, picture_size(), found->position), pixel = pixel_at(position);
    return std::hypot(at.x - pixel.x, at.y - pixel.y) < reach * devicePixelRatioF();
}

QString SceneView::item_with_handles() const {
    if (picks_places_ || !scene_) return {};
    if (moved_) return to_qt(moved_->item.id);
    return reached_.isEmpty() ? selected_ : reached_;
}

void SceneView::bring_item_to(QPointF position, Qt::KeyboardModifiers keys) {
    brought_to_ = position;
    const bool snaps = keys.testFlag(Qt::ControlModifier);
    if (moved_->turns())
        turn_item_to(position, snaps);
    else
        move_item_to(position, snaps);
}

void SceneView::move_item_to(QPointF position, bool snaps) {
    const QPointF at = position * devicePixelRatioF() + grip_;
    const PictureSize size = picture_size();
    const SceneItem& item = moved_->item;
    Eigen::Vector3d p_W =
        moved_->axis < 0 ? world_at(camera_, size, {at.x(), at.y()}, item.position)
                         : moved_along(*moved_, camera_, size, pixel_at(*pressed_at_), pixel_at(position));
    double step = metres_per_pixel(camera_, size, item.position);
    if (snaps) {
        step = nearest_round_number(pixels_per_snap * step);
        p_W = snapped(item, p_W, step);
    }
    emit item_dragged(item, p_W, step);
}

void SceneView::turn_item_to(QPointF position, bool snaps) {
    const PictureSize size = picture_size();
    const SceneFrame& frame = *moved_->frame;
    const Eigen::Matrix3d turn = turn_by(*moved_, camera_, size, pixel_at(*pressed_at_), pixel_at(position),
                                         snaps ? degrees_per_snap * std::numbers::pi / 180 : 0.0);
    const double step = metres_per_pixel(camera_, size, frame.item.position) / frame.length;
    emit item_turned(moved_->item, turn * frame.R_WF, step);
}

void SceneView::drag_by(QPointF delta) {
    const double ratio = devicePixelRatioF();
    const QPointF d = delta * ratio;
    const bool pans =
        button_ == Qt::MiddleButton ||
        (button_ == Qt::LeftButton && QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier));
    if (pans)
        post_framing([d](SceneRenderer& renderer) { renderer.pan(d.x(), d.y()); });
    else if (button_ == Qt::RightButton)
        post_framing([d](SceneRenderer& renderer) { renderer.zoom(std::exp(-0.005 * d.y())); });
    else
        post_moving([d](SceneRenderer& renderer) { renderer.orbit(d.x(), d.y()); });
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    const bool clicked = !dragged_ && event->button() == Qt::LeftButton;
    if (const auto face = face_under(event->position()); face && clicked) {
        set_view(*face);
    } else if (clicked && picks_places_) {
        if (const auto place = place_under(event->position()))
            emit place_picked(QString::fromStdString(*place));
    } else if (clicked && scene_) {
        picked_trial_ = trial_under(event->position());
        update();
        const QPointF at = event->position() * devicePixelRatioF();
        service_.pick(at.x(), at.y());
    }
    if (moved_ && dragged_) {
        // Not brought to the same place again: the picture may have changed under a hand that rests.
        if (brought_to_ != event->position()) bring_item_to(event->position(), event->modifiers());
        emit drag_finished();
        emit item_picked(selected_);  // its values stand in the form, to be typed
    }
    end_press();
}

void SceneView::end_press() {
    since_move_.invalidate();
    brought_to_.reset();
    moved_.reset();
    pressed_at_.reset();
    button_ = Qt::NoButton;
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (face_under(event->position()) || want_coordinates(item_under(event->position()))) return;
    fit();
}

void SceneView::wheelEvent(QWheelEvent* event) {
    const double factor = std::pow(1.0015, event->angleDelta().y());
    post_framing([factor, about = pixel_at(event->position())](SceneRenderer& renderer) {
        renderer.zoom(factor, about);
    });
    event->accept();
}

/// Takes Escape while a tool is in use: it then stops no run.
bool SceneView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && picks_places_ &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
        event->accept();
    return QWidget::event(event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    const QPointF turn = orbit_of_key(event->key());
    if (const auto view = view_of_key(event->key()))
        set_view(*view);
    else if (!turn.isNull())
        post_moving([turn](SceneRenderer& renderer) { renderer.orbit(turn.x(), turn.y()); });
    else if (event->key() == Qt::Key_F)
        fit();
    else if (event->key() == Qt::Key_Escape && picks_places_)
        emit tool_left();
    else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal)
        post_framing([](SceneRenderer& renderer) { renderer.zoom(zoom_per_key); });
    else if (event->key() == Qt::Key_Minus)
        post_framing([](SceneRenderer& renderer) { renderer.zoom(1.0 / zoom_per_key); });
    else if (!take_key(*event))
        QWidget::keyPressEvent(event);
}

/// Acts on keys for the selected item; false: the key is none of them.
bool SceneView::take_key(const QKeyEvent& event) {
    if (event.key() == Qt::Key_H && event.modifiers() == Qt::ShiftModifier)
        show_all();
    else if (event.key() == Qt::Key_H && event.modifiers() == Qt::NoModifier)
        hide_item(selected_);
    else if (event.key() == Qt::Key_I && event.modifiers() == Qt::NoModifier)
        show_alone(selected_);
    else if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter || event.key() == Qt::Key_F2)
        return want_coordinates(selected_);
    else
        return false;
    return true;
}

void SceneView::hide_item(const QString& item_id) {
    Visibility visibility = visibility_;
    const std::string thing = whole_ ? thing_of(*whole_, to_std(item_id)) : std::string();
    if (visibility.only == thing) visibility.only.clear();
    if (!thing.empty()) visibility.hidden.insert(thing);
    set_visibility(visibility);
}

void SceneView::show_alone(const QString& item_id) {
    if (item_id.isEmpty() || !whole_) return;
    set_visibility({{}, thing_of(*whole_, to_std(item_id))});
    fit();
}

bool SceneView::want_coordinates(const QString& item_id) {
    const SceneItem* item = scene_ ? find_item(*scene_, item_id.toStdString()) : nullptr;
    if (!item || item->source.path.empty() || picks_places_) return false;
    emit coordinates_wanted(*item);
    return true;
}

QString SceneView::item_under(QPointF position) const {
    if (!scene_ || image_.isNull()) return {};
    const QPointF at = position * devicePixelRatioF();
    const auto shown = [this](Layer layer) { return layers_[layer]; };
    return QString::fromStdString(
        pick_item(*scene_, camera_, picture_size(), {at.x(), at.y()}, shown, 6.0 * devicePixelRatioF())
            .value_or(std::string()));
}

QString SceneView::item_for_menu(const QContextMenuEvent& event) const {
    if (!scene_ || image_.isNull()) return {};
    if (event.reason() == QContextMenuEvent::Keyboard)
        return find_item(*scene_, selected_.toStdString()) ? selected_ : QString();
    return item_under(event.pos());
}

void SceneView::contextMenuEvent(QContextMenuEvent* event) {
    if (dragged_) return;  // the end of a right drag
    QMenu menu(this);
    if (const QString item = item_for_menu(*event); !item.isEmpty()) {
        if (const SceneItem* found = find_item(*scene_, item.toStdString());
            found && !found->source.path.empty())
            menu.addAction(tr("Type Coordinates"), this, [this, item] { want_coordinates(item); });
        menu.addAction(tr("Hide"), this, [this, item] { hide_item(item); });
        menu.addAction(tr("Show Only This"), this, [this, item] { show_alone(item); });
    }
    if (!visibility_.shows_all()) menu.addAction(tr("Show All"), this, &SceneView::show_all);
    if (!menu.isEmpty()) menu.addSeparator();
    menu.addAction(tr("Fit"), this, &SceneView::fit);
    menu.addAction(tr("Copy Picture"), this, &SceneView::copy_picture);
    menu.addAction(tr("Save Picture …"), this, [this] {
        const QString file = QFileDialog::getSaveFileName(this, tr("Save Picture"), tr("scene.png"),
                                                          tr("PNG picture (*.png)"));
        if (!file.isEmpty()) save_picture(file, saved_picture_size);
    });
    menu.exec(event->globalPos());
    end_press();  // the menu had the release of the button
}

}  // namespace covaria::ui
