// The 3D view: paints the pictures of a RenderService and turns the mouse and keyboard into camera movements.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

#include "ui/scene_view/render_service.h"

namespace covaria::ui {

/// Left drag orbits, middle or Shift+left drag pans, wheel or right drag zooms, click selects, double click
/// fits. A selected item whose position is written in the project is moved by dragging it, in the plane of
/// the picture. Keys: arrows orbit, plus and minus zoom, F fits, 1 iso, 2 top, 3 front, 4 right.
class SceneView : public QWidget {
    Q_OBJECT
public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    void show_scene(std::shared_ptr<const Scene> scene);
    const Scene* scene() const { return scene_.get(); }
    void set_palette_kind(ScenePalette palette);
    void set_layers(const LayerVisibility& layers);
    void set_view(StandardView view);
    void fit();
    /// The next scene is of something else: seen from the usual side, with nothing selected.
    void start_over();
    /// Marks an item without telling anybody; empty = none.
    void select(const QString& item_id);
    const QString& selected() const { return selected_; }
    /// What is shown instead of a picture while there is no scene: what to do next.
    void set_empty_text(const QString& text);
    const QString& empty_text() const { return empty_text_; }

    const QImage& image() const { return image_; }
    void copy_picture();
    /// Asks the service for a picture of `size` and writes it; `picture_saved` answers.
    void save_picture(const QString& file, QSize size);
    RenderService& service() { return service_; }

    QSize sizeHint() const override { return {800, 500}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    /// The user clicked on an item (empty: on nothing).
    void item_picked(const QString& item_id);
    void picture_saved(const QString& file, const QString& problem);
    /// The user drags an item (as it was when the drag began) to a point of W, known to about `step` m.
    void item_dragged(const covaria::SceneItem& item, const Eigen::Vector3d& p_W, double step);
    void drag_finished();

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void contextMenuEvent(QContextMenuEvent*) override;

private:
    void send_size();
    void drag_by(QPointF delta);
    /// The selected item, if it can be moved and is under the pointer.
    const SceneItem* movable_at(QPointF position) const;
    void move_item_to(QPointF position);
    PictureSize picture_size() const;
    void post_moving(RenderService::Step step) { service_.post(std::move(step), RenderQuality::moving); }
    /// Pan and zoom: from then on the user decides what is in the picture.
    void post_framing(RenderService::Step step);
    void finish_save(const QImage& image);

    std::shared_ptr<const Scene> scene_;
    QImage image_;
    Camera camera_;  ///< of the image
    bool starts_over_ = false;
    QString selected_;
    QString empty_text_;
    QString failure_;
    QString file_to_save_;
    std::optional<QPointF> pressed_at_;
    QPointF last_at_;
    Qt::MouseButton button_ = Qt::NoButton;
    bool dragged_ = false;
    std::optional<SceneItem> moved_;  ///< being dragged: as it was
    QElapsedTimer since_move_;
    QPointF grip_;        ///< from the pointer to its middle, device pixels
    bool framed_ = true;  ///< everything is in the picture, and stays so when the pane changes its size
    RenderService service_;
};

}  // namespace covaria::ui
