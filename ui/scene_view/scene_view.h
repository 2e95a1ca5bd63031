// The 3D view: paints the pictures of a RenderService and turns the mouse and keyboard into camera movements.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

#include "core/project/saved_view.h"
#include "ui/scene_view/render_service.h"
#include "viz/scene/framing.h"
#include "viz/scene/handles.h"
#include "viz/scene/view_cube.h"
#include "viz/scene/visibility.h"

namespace covaria::ui {

/// Property, a bool: the picture is faint, being of a state that is no more.
inline constexpr char is_faint[] = "is_faint";

/// Left drag orbits, middle or Shift+left drag pans, wheel or right drag zooms, click selects, double click
/// fits. An item whose position is written in the project is moved by dragging it, in the plane of the
/// picture, or along one axis by its arrows, and turned by the tips of its axes; with Ctrl in round steps.
/// The cursor says what can be dragged. The cube in the corner turns to its faces. Keys: arrows orbit, plus
/// and minus zoom, F fits, 1 to 7 are the standard views, H hides what is selected, I shows it alone, Shift+H
/// shows all.
class SceneView : public QWidget {
    Q_OBJECT
public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    void show_scene(std::shared_ptr<const Scene> scene);
    /// The part of the scene that is shown.
    const Scene* scene() const { return scene_.get(); }
    void set_visibility(const Visibility& visibility);
    void show_all();  ///< in the picture, where one thing was framed
    const Visibility& visibility() const { return visibility_; }
    const Camera& camera() const { return camera_; }  ///< of the picture
    /// Whether any item from the set-up of an asset is shown; empty: it has nothing in the scene.
    std::optional<bool> shows_asset(const QString& asset) const;
    void show_asset(const QString& asset, bool shown);
    /// Cuts the scene at a plane; without one it is whole. `moving`: another one follows soon.
    void set_section(const std::optional<SectionPlane>& section, bool moving = false);
    void set_palette_kind(ScenePalette palette);
    void set_layers(const LayerVisibility& layers);
    void set_view(StandardView view);
    void set_perspective(bool perspective);
    void show_view(const SavedView& view);
    /// The present view under this name.
    SavedView saved(const std::string& name) const;
    void fit();
    /// The faces of the cube in the corner that can be seen.
    std::vector<CubeFace> cube() const;
    /// Forgets the view: the next scene is another thing's, seen from the usual side, with nothing selected.
    void start_over();
    /// Marks an item without telling anybody; empty = none.
    void select(const QString& item_id);
    const QString& selected() const { return selected_; }
    /// Whether an item, not the camera, is dragged.
    bool is_dragging() const { return moved_ && dragged_; }
    /// A click picks a place and moves nothing while a tool asks for places.
    void set_picks_places(bool picks);
    bool picks_places() const { return picks_places_; }
    void set_measure(MeasureMark mark);
    /// px at its foot that words lie over: caption and scale bar stand above them.
    void set_covered(int height);
    /// Sets the text shown instead of a picture while there is no scene: what to do next.
    void set_empty_text(const QString& text);
    const QString& empty_text() const { return empty_text_; }

    const QImage& image() const { return image_; }
    void copy_picture();
    /// Asks the service for a picture of `size` and writes it; `picture_saved` answers.
    void save_picture(const QString& file, QSize size);
    RenderService& service() { return service_; }

    QSize sizeHint() const override { return {800, 500}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

    /// The trial of the last click, where it hit a dot of a cloud.
    std::optional<std::uint64_t> picked_trial() const { return picked_trial_; }
    /// Takes the rings from the dots of the trial.
    void forget_trial();

signals:
    /// The user clicked on an item (empty: on nothing).
    void item_picked(const QString& item_id);
    /// The user clicked while places are picked.
    void place_picked(const QString& item_id);
    void tool_left();  ///< Escape
    /// The user wants to type the position of an item.
    void coordinates_wanted(const covaria::SceneItem& item);
    void perspective_changed(bool perspective);
    void picture_saved(const QString& file, const QString& problem);
    /// The user drags an item (as it was when the drag began) to a point of W, known to about `step` m.
    void item_dragged(const covaria::SceneItem& item, const Eigen::Vector3d& p_W, double step);
    /// The user turns an item to an orientation in W, known to about `step` rad.
    void item_turned(const covaria::SceneItem& item, const Eigen::Matrix3d& R_WF, double step);
    void drag_started();
    void drag_finished();

protected:
    bool event(QEvent*) override;
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void leaveEvent(QEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void contextMenuEvent(QContextMenuEvent*) override;

private:
    static constexpr double reach_of_handles = 72.0;  ///< pixels in which an item keeps its handles
    static constexpr double length_of_arrow = 58.0;   ///< px, of the arrow that moves an item along an axis
    void send_size();
    void end_press();
    void send_scene(RenderQuality quality = RenderQuality::full);
    void take_image(const QImage& image, const Camera& camera);
    void hide_item(const QString& item_id);
    /// Asks for the coordinates of an item that a set-up states; false: none does.
    bool want_coordinates(const QString& item_id);
    QString item_under(QPointF position) const;
    void show_alone(const QString& item_id);
    /// The item that a context menu is about; empty: none.
    QString item_for_menu(const QContextMenuEvent& event) const;
    QRectF place_of_cube() const;
    ScreenRect pixels_of_cube() const;
    std::optional<StandardView> face_under(QPointF position) const;
    bool take_key(const QKeyEvent& event);
    void drag_by(QPointF delta);
    /// The handle that a drag from there would grasp.
    std::optional<Handle> handle_under(QPointF position) const;
    bool is_near(const QString& item, QPointF position, double reach = reach_of_handles) const;
    /// The item that the pointer is or was at, else the one selected.
    QString item_with_handles() const;
    std::optional<std::uint64_t> trial_under(QPointF position) const;
    void paint_picture(QPainter& painter) const;
    /// Paints a ring around the dot of a trial in every cloud.
    void paint_trial(QPainter& painter, std::uint64_t trial) const;
    void bring_item_to(QPointF position, Qt::KeyboardModifiers keys);
    void move_item_to(QPointF position, bool snaps);
    void turn_item_to(QPointF position, bool snaps);
    Pixel pixel_at(QPointF position) const;
    PictureSize picture_size() const;
    std::optional<std::string> place_under(QPointF position) const;
    void follow_pointer(QPointF position);
    void point_at(const QString& item);
    void post_moving(RenderService::Step step) { service_.post(std::move(step), RenderQuality::moving); }
    /// Posts a pan or zoom: from then on the user decides what is in the picture.
    void post_framing(RenderService::Step step);
    void finish_save(const QImage& image);

    std::shared_ptr<const Scene> whole_;
    std::shared_ptr<const Scene> scene_;  ///< the part of `whole_` that is shown, with its section
    Visibility visibility_;
    std::optional<SectionPlane> section_;
    std::optional<StandardView> pointed_;  ///< face of the cube under the pointer
    QImage image_;
    Camera camera_;  ///< the camera of the image
    bool starts_over_ = false;
    int covered_ = 0;
    QString selected_;
    QString pointed_item_;   ///< its name is written because the pointer is at it
    QString reached_;        ///< the item whose handles show because the pointer came to it
    int grasped_axis_ = -1;  ///< axis of the arrow under the pointer
    ScenePalette palette_ = {};
    LayerVisibility layers_;
    bool picks_places_ = false;
    QString empty_text_;
    QString failure_;
    QString file_to_save_;
    std::optional<QPointF> pressed_at_;
    QPointF last_at_;
    Qt::MouseButton button_ = Qt::NoButton;
    bool dragged_ = false;
    std::optional<Handle> moved_;  ///< being dragged: as it was
    QElapsedTimer since_move_;
    std::optional<std::uint64_t> picked_trial_;
    std::optional<QPointF> brought_to_;  ///< last place to which the present drag brought the item
    QPointF grip_;                       ///< offset of the item's middle from the pointer, device pixels
    bool framed_ = true;  ///< everything is in the picture, and stays so when the pane changes its size
    Framing framing_;
    RenderService service_;
};

}  // namespace covaria::ui
