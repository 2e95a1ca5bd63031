#include "ui/scene_view/scene_view.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>
#include <utility>

namespace covaria::ui {
namespace {

constexpr double pixels_per_key = 30.0;
constexpr qint64 least_pause_between_moves = 25;  // ms
constexpr double reach_of_pointer = 14.0;         // pixels around a selected item in which it can be grasped
constexpr double zoom_per_key = 1.15;
constexpr QSize saved_picture_size(2560, 1600);

std::optional<StandardView> view_of_key(int key) {
    switch (key) {
        case Qt::Key_1:
            return StandardView::iso;
        case Qt::Key_2:
            return StandardView::top;
        case Qt::Key_3:
            return StandardView::front;
        case Qt::Key_4:
            return StandardView::right;
        default:
            return {};
    }
}

QPointF orbit_of_key(int key) {
    switch (key) {
        case Qt::Key_Left:
            return {-pixels_per_key, 0};
        case Qt::Key_Right:
            return {pixels_per_key, 0};
        case Qt::Key_Up:
            return {0, -pixels_per_key};
        case Qt::Key_Down:
            return {0, pixels_per_key};
        default:
            return {};
    }
}

}  // namespace

SceneView::SceneView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setAccessibleName(tr("3D scene"));
    setAccessibleDescription(
        tr("Arrow keys turn the scene, plus and minus zoom, F fits, 1 to 4 are standard views; a selected "
           "point or instrument can be dragged to another place"));
    connect(&service_, &RenderService::rendered, this, [this](const QImage& image, const Camera& camera) {
        image_ = image;
        camera_ = camera;
        failure_.clear();
        update();
    });
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

void SceneView::show_scene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    if (scene_)
        service_.post(
            [shown = scene_, framed = framed_,
             first = std::exchange(starts_over_, false)](SceneRenderer& renderer) {
                const bool other = renderer.scene().title != shown->title;
                renderer.set_scene(*shown);
                if (first)
                    renderer.set_view(StandardView::iso);
                else if (other && framed)
                    renderer.fit();
            },
            moved_ ? RenderQuality::moving : RenderQuality::full);
    update();
}

void SceneView::set_palette_kind(ScenePalette palette) {
    service_.post([palette](SceneRenderer& renderer) { renderer.set_palette(palette); });
}

void SceneView::set_layers(const LayerVisibility& layers) {
    service_.post([layers](SceneRenderer& renderer) { renderer.set_layers(layers); });
}

void SceneView::set_view(StandardView view) {
    framed_ = true;
    service_.post([view](SceneRenderer& renderer) { renderer.set_view(view); });
}

void SceneView::fit() {
    framed_ = true;
    service_.post([](SceneRenderer& renderer) { renderer.fit(); });
}

void SceneView::start_over() {
    starts_over_ = framed_ = true;
    select({});
}

void SceneView::select(const QString& item_id) {
    if (item_id == selected_) return;
    selected_ = item_id;
    service_.post([id = item_id.toStdString()](SceneRenderer& renderer) { renderer.set_selected(id); });
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

void SceneView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    if (scene_ && !image_.isNull() && failure_.isEmpty()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(rect(), image_);
        return;
    }
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QString text = failure_.isEmpty() ? (scene_ ? tr("Drawing …") : empty_text_) : failure_;
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void SceneView::post_framing(RenderService::Step step) {
    framed_ = false;
    post_moving(std::move(step));
}

void SceneView::send_size() {
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(size()) * ratio).toSize();
    post_moving([pixels, ratio, framed = framed_](SceneRenderer& renderer) {
        renderer.set_size(pixels.width(), pixels.height());
        renderer.set_pixel_ratio(ratio);
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
    const SceneItem* item = button_ == Qt::LeftButton ? movable_at(event->position()) : nullptr;
    if (!item) return;
    moved_ = *item;
    const Pixel at = project(camera_, picture_size(), item->position);
    grip_ = QPointF(at.x, at.y) - event->position() * devicePixelRatioF();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    if (!pressed_at_) return setCursor(movable_at(event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    if (!dragged_ && (event->position() - *pressed_at_).manhattanLength() < 4) return;
    dragged_ = true;
    if (moved_) {
        // A mouse reports more often than results can follow.
        if (since_move_.isValid() && since_move_.elapsed() < least_pause_between_moves) return;
        since_move_.start();
        return move_item_to(event->position());
    }
    drag_by(event->position() - last_at_);
    last_at_ = event->position();
}

PictureSize SceneView::picture_size() const {
    return {image_.width(), image_.height()};
}

const SceneItem* SceneView::movable_at(QPointF position) const {
    const SceneItem* item =
        scene_ && !image_.isNull() ? find_item(*scene_, selected_.toStdString()) : nullptr;
    if (!item || !item->source.draggable) return nullptr;
    const Pixel at = project(camera_, picture_size(), item->position);
    const QPointF away = position * devicePixelRatioF() - QPointF(at.x, at.y);
    return std::hypot(away.x(), away.y()) < reach_of_pointer * devicePixelRatioF() ? item : nullptr;
}

void SceneView::move_item_to(QPointF position) {
    const QPointF at = position * devicePixelRatioF() + grip_;
    const PictureSize size = picture_size();
    emit item_dragged(*moved_, world_at(camera_, size, {at.x(), at.y()}, moved_->position),
                      metres_per_pixel(camera_, size));
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
    if (!dragged_ && event->button() == Qt::LeftButton && scene_) {
        const QPointF at = event->position() * devicePixelRatioF();
        service_.pick(at.x(), at.y());
    }
    if (moved_ && dragged_) {
        move_item_to(event->position());
        emit drag_finished();
    }
    since_move_.invalidate();
    moved_.reset();
    pressed_at_.reset();
    button_ = Qt::NoButton;
}

void SceneView::mouseDoubleClickEvent(QMouseEvent*) {
    fit();
}

void SceneView::wheelEvent(QWheelEvent* event) {
    const double factor = std::pow(1.0015, event->angleDelta().y());
    post_framing([factor](SceneRenderer& renderer) { renderer.zoom(factor); });
    event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    const QPointF turn = orbit_of_key(event->key());
    if (const auto view = view_of_key(event->key()))
        set_view(*view);
    else if (!turn.isNull())
        post_moving([turn](SceneRenderer& renderer) { renderer.orbit(turn.x(), turn.y()); });
    else if (event->key() == Qt::Key_F)
        fit();
    else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal)
        post_framing([](SceneRenderer& renderer) { renderer.zoom(zoom_per_key); });
    else if (event->key() == Qt::Key_Minus)
        post_framing([](SceneRenderer& renderer) { renderer.zoom(1.0 / zoom_per_key); });
    else
        QWidget::keyPressEvent(event);
}

void SceneView::contextMenuEvent(QContextMenuEvent* event) {
    if (dragged_) return;  // the end of a right drag
    QMenu menu(this);
    menu.addAction(tr("Fit"), this, &SceneView::fit);
    menu.addAction(tr("Copy Picture"), this, &SceneView::copy_picture);
    menu.addAction(tr("Save Picture …"), this, [this] {
        const QString file = QFileDialog::getSaveFileName(this, tr("Save Picture"), tr("scene.png"),
                                                          tr("PNG picture (*.png)"));
        if (!file.isEmpty()) save_picture(file, saved_picture_size);
    });
    menu.exec(event->globalPos());
}

}  // namespace covaria::ui
