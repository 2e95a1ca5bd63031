// Realises a Scene: off screen, on an OpenGL context of its own, with no display. No VTK in this header.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "viz/scene/camera.h"
#include "viz/scene/label_placement.h"
#include "viz/scene/measurement.h"
#include "viz/scene/scene.h"
#include "viz/vtk/image.h"

namespace covaria {

enum class ScenePalette { light, dark };

enum class RenderQuality {
    moving,  ///< while the camera moves: thinned clouds, no smoothing, translucency unsorted
    full,    ///< sorted translucency, smoothed edges
    fine,    ///< draws as full, from twice the resolution: for files and reports
};

struct LayerVisibility {
    std::array<bool, layer_count> shown;
    /// Distributions and axes only when somebody asks for them: a picture is read by its bodies and
    /// ellipsoids.
    LayerVisibility() {
        shown.fill(true);
        for (const Layer asked : {Layer::clouds, Layer::wall_histograms, Layer::axes}) (*this)[asked] = false;
    }
    bool operator[](Layer layer) const { return shown[static_cast<std::size_t>(layer)]; }
    bool& operator[](Layer layer) { return shown[static_cast<std::size_t>(layer)]; }
    bool operator==(const LayerVisibility&) const = default;
};

/// Messages of VTK and OpenGL go here and not to the terminal; called from any rendering thread. Without a
/// log they are dropped.
void set_rendering_log(std::function<void(const std::string&)> log);

/// One renderer may be used from any thread, by one thread at a time; several renderers at the same time are
/// independent.
class SceneRenderer {
public:
    SceneRenderer();
    ~SceneRenderer();
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;

    /// Error{io}: this machine offers no OpenGL through EGL; the message says what is missing.
    Result<void> open();

    /// Rebuilds what differs from the scene before. The first scene that is not empty sets the camera to iso.
    void set_scene(Scene scene);
    const Scene& scene() const;

    void set_palette(ScenePalette palette);
    /// Sets the size in device pixels; clamped to 1 ... 16384.
    void set_size(int width, int height);
    PictureSize size() const;
    /// Size of letters and line widths: 1 at 96 dots per inch, 2 on a display of twice the density.
    /// 0 (the default) = chosen from the size of the picture.
    void set_pixel_ratio(double ratio);
    void set_layers(const LayerVisibility& layers);
    LayerVisibility layers() const;
    void set_selected(const std::string& item_id);  ///< empty = none
    void set_pointed(const std::string& item_id);   ///< id of the item under the pointer; empty = none
    void set_measure(MeasureMark mark);             ///< without places: none
    const MeasureMark& measure() const;
    /// Sets pixels that are painted over: words stay clear of them.
    void set_reserved(const ScreenRect& rect);
    /// Caption and scale bar stand above what covers so many px of the foot.
    void set_covered(double height);

    void set_view(StandardView view);  ///< direction, and everything in the picture
    void fit();
    void set_perspective(bool perspective);  ///< keeps direction and height
    void orbit(double dx, double dy);        ///< pixels of a drag
    void pan(double dx, double dy);
    void zoom(double factor);
    void zoom(double factor, Pixel about);  ///< the point there stays there
    Camera camera() const;
    void set_camera(const Camera& camera);

    /// Opens if need be. Errors as `open`, or the graphics memory is too small for the size.
    Result<Image> render(RenderQuality quality = RenderQuality::full);

    /// Id of the item under a pixel (points before ellipsoids before links before bodies).
    std::optional<std::string> pick(double x, double y) const;
    Pixel project(const Eigen::Vector3d& p_W) const;
    /// The point of W under a pixel, in the plane through `through_W` parallel to the picture.
    Eigen::Vector3d world_at(double x, double y, const Eigen::Vector3d& through_W) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace covaria
