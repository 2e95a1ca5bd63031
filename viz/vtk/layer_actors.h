// The actors of a scene, layer by layer; a layer is rebuilt only when what it shows has changed.
#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <array>
#include <mutex>
#include <optional>
#include <vector>

#include "viz/scene/camera.h"
#include "viz/vtk/palette.h"
#include "viz/vtk/section_cut.h"
#include "viz/vtk/shading.h"

namespace covaria::detail {

/// An actor and how it follows the camera, the pixel density and the quality.
struct LayerActor {
    vtkSmartPointer<vtkActor> actor;
    double line_width = 0.0;  ///< in units of the pixel ratio; 0 = no lines
    double point_size = 0.0;  ///< in units of the pixel ratio; 0 = no points
    /// Number of points of a cloud and radius (m) in which most lie; the denser they are in the picture, the
    /// fainter each is drawn.
    double cloud_points = 0.0;
    double cloud_radius = 0.0;
    /// A wall stands at the side of its box that is farther from the eye: normal direction (0 x, 1 y, 2 z)
    /// and the way from the low to the high side. -1 = no wall.
    int wall_normal = -1;
    double wall_shift = 0.0;
    enum class Shown { always, still, moving } shown = Shown::always;  ///< thinned twins of clouds
    std::optional<Surface> surface = {};                               ///< its shaders follow the camera
    /// The floor: a plane has no part in the occlusion of bodies, which would mottle it, so it is drawn with
    /// what is translucent. Where that is unsorted it would lie over all bodies.
    bool is_floor = false;
};

class LayerActors {
public:
    explicit LayerActors(vtkRenderer* renderer) : renderer_(renderer) {}

    /// `before` is the scene the layers were last built from (null: build all).
    void update(const Scene& scene, const Scene* before, ScenePalette palette);
    struct View {
        Camera camera;
        LayerVisibility layers;
        double ratio = 1.0;
        double metres_per_pixel = 1.0;
        bool moving = false;
        PictureSize size = {};  ///< pixels in which the picture is drawn
        std::optional<SectionPlane> section = {};
    };
    /// Visibility, widths, walls and the section for the next picture.
    void prepare(const View& view);
    const Eigen::Vector3d& origin() const { return origin_; }

private:
    void rebuild(Layer layer, const Scene& scene, ScenePalette palette);
    void rebuild_caps(const Scene& scene);
    void cut(Layer layer, const LayerActor& item) const;
    void prepare(Layer layer, LayerActor& item, const View& view, const ShadingView& shading) const;

    vtkRenderer* renderer_;
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
    ScenePalette palette_ = ScenePalette::light;
    SectionCut cut_;
    std::array<std::vector<LayerActor>, layer_count> actors_;
    std::array<std::vector<LayerActor>, layer_count> caps_;  ///< of solids, in the plane of the section
};

/// Guards the building of meshes, which uses objects that VTK and we share within the process.
std::mutex& mesh_mutex();
/// The actors of one layer (none for labels and legend, which are painted on the picture).
std::vector<LayerActor> actors_of(Layer layer, const Scene& scene, const Eigen::Vector3d& origin,
                                  ScenePalette palette);
std::vector<LayerActor> axes_actors(const Scene& scene, const Eigen::Vector3d& origin, ScenePalette palette);
std::vector<LayerActor> histogram_actors(const Scene& scene, const Eigen::Vector3d& origin,
                                         ScenePalette palette);
/// Coloured points of a map, and iso-surfaces of a grid of them.
std::vector<LayerActor> map_actors(const Scene& scene, const Eigen::Vector3d& origin, ScenePalette palette);
/// Context; the triangles of a mesh are VTK's once, however often its actor is made.
std::vector<LayerActor> mesh_actors(const Scene& scene, const Eigen::Vector3d& origin, ScenePalette palette);
/// The floor under everything, with its shadow.
std::vector<LayerActor> floor_actors(const Scene& scene, const Eigen::Vector3d& origin, ScenePalette palette);
std::vector<LayerActor> cloud_actors(const Scene& scene, const Eigen::Vector3d& origin, ScenePalette palette);

}  // namespace covaria::detail
