// Choice of the layers to rebuild, and the way in which actors follow the camera.
#include "viz/vtk/layer_actors.h"

#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "viz/scene/solids.h"
#include "viz/vtk/section_caps.h"

namespace covaria::detail {
namespace {

bool same(Layer layer, const Scene& a, const Scene& b) {
    switch (layer) {
        case Layer::frames:
            return a.frames == b.frames;
        case Layer::points:
            return a.points == b.points;
        case Layer::bodies:
            // The shadow on the floor is that of all of them.
            return a.bodies == b.bodies && a.floor == b.floor && a.links == b.links && a.points == b.points;
        case Layer::links:
            return a.links == b.links && a.section == b.section;  // lines end at it
        case Layer::vectors:
            return a.vectors == b.vectors;
        case Layer::ellipsoids:
            return a.ellipsoids == b.ellipsoids;
        case Layer::ellipsoids_before:
            return a.ellipsoids_before == b.ellipsoids_before;
        case Layer::clouds:
            return a.clouds == b.clouds;
        case Layer::wall_histograms:
            return a.wall_histograms == b.wall_histograms;
        case Layer::axes:
            return a.axes == b.axes;
        case Layer::map:
            return a.map == b.map;
        case Layer::meshes:
            return a.meshes == b.meshes;
        case Layer::labels:
        case Layer::legend:
            return true;
    }
    return false;
}

/// Opacity of a cloud's dots: a dense middle does not saturate, and single trials are still seen.
double cloud_opacity(const LayerActor& cloud, const LayerActors::View& view) {
    const double radius = std::max(1.0, cloud.cloud_radius / view.metres_per_pixel);
    const double side = cloud.point_size * view.ratio;
    const double density = cloud.cloud_points * side * side / (std::numbers::pi * radius * radius);
    return std::clamp(0.68 / std::sqrt(density), 0.2, 0.85);
}

}  // namespace

std::mutex& mesh_mutex() {
    static std::mutex mutex;
    return mutex;
}

void LayerActors::update(const Scene& scene, const Scene* before, ScenePalette palette) {
    const SceneBounds bounds = bounds_of(scene);
    const Eigen::Vector3d middle = (bounds.low + bounds.high) / 2;
    // The origin moves only when it has become far: then everything is built anew.
    const bool far = (middle - origin_).norm() > 10 * (bounds.high - bounds.low).norm();
    if (!before || far) origin_ = middle;
    palette_ = palette;
    for (std::size_t i = 0; i < layer_count; ++i) {
        const auto layer = static_cast<Layer>(i);
        if (!before || far || !same(layer, scene, *before)) rebuild(layer, scene, palette);
    }
    rebuild_caps(scene);
    // Clouds blend over what is there already: they come after all other opaque actors.
    for (const LayerActor& cloud : actors_[static_cast<std::size_t>(Layer::clouds)]) {
        renderer_->RemoveActor(cloud.actor);
        renderer_->AddActor(cloud.actor);
    }
}

void LayerActors::rebuild(Layer layer, const Scene& scene, ScenePalette palette) {
    auto& actors = actors_[static_cast<std::size_t>(layer)];
    for (const LayerActor& old : actors) renderer_->RemoveActor(old.actor);
    // Frames are painted on the picture, of what is selected.
    actors = layer == Layer::frames ? std::vector<LayerActor>{} : actors_of(layer, scene, origin_, palette);
    if (layer == Layer::bodies)
        for (LayerActor& floor : floor_actors(scene, origin_, palette)) actors.push_back(std::move(floor));
    for (const LayerActor& added : actors) renderer_->AddActor(added.actor);
}

/// What stands on the walls is no part of the space that is cut; dashed lines end at the plane by themselves,
/// since the clipping planes of VTK 9.1 and an input of our own to its shaders lose whole lines.
void LayerActors::cut(Layer layer, const LayerActor& item) const {
    if (layer == Layer::meshes)
        cut_.apply_to_mesh(*item.actor);
    else if (layer != Layer::axes && layer != Layer::wall_histograms && item.surface != Surface::dashed)
        cut_.apply(*item.actor);
}

void LayerActors::rebuild_caps(const Scene& scene) {
    const std::pair<Layer, std::vector<Solid> (*)(const Scene&)> solid_layers[] = {
        {Layer::bodies, solids_of_bodies},
        {Layer::links, solids_of_links},
        {Layer::points, solids_of_points}};
    for (const auto& [layer, solids] : solid_layers) {
        auto& caps = caps_[static_cast<std::size_t>(layer)];
        for (const LayerActor& old : caps) renderer_->RemoveActor(old.actor);
        caps.clear();
        if (scene.section) caps = cap_actors(solids(scene), scene, origin_, palette_);
        for (const LayerActor& added : caps) renderer_->AddActor(added.actor);
    }
}

void LayerActors::prepare(const View& view) {
    cut_.set(view.section, origin_, palette_);
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const ShadingView shading{
        {view.camera.right().dot(up), view.camera.up.dot(up), -view.camera.direction.dot(up)},
        double(view.size.width),
        double(view.size.height),
        view.ratio,
        cut_.is_on()};
    for (auto* all : {&actors_, &caps_})
        for (std::size_t i = 0; i < layer_count; ++i)
            for (LayerActor& item : (*all)[i]) prepare(static_cast<Layer>(i), item, view, shading);
}

void LayerActors::prepare(Layer layer, LayerActor& item, const View& view, const ShadingView& shading) const {
    const bool hidden = item.shown == (view.moving ? LayerActor::Shown::still : LayerActor::Shown::moving);
    item.actor->SetVisibility(view.layers[layer] && !hidden);
    vtkProperty* property = item.actor->GetProperty();
    if (item.line_width > 0) property->SetLineWidth(static_cast<float>(item.line_width * view.ratio));
    if (item.point_size > 0)
        property->SetPointSize(static_cast<float>(std::max(1.0, item.point_size * view.ratio)));
    if (item.cloud_points > 0) property->SetOpacity(cloud_opacity(item, view));
    if (item.is_floor) {
        item.actor->SetForceOpaque(view.moving);
        item.actor->SetForceTranslucent(!view.moving);
    }
    cut(layer, item);
    if (item.surface) set_view(item.actor, *item.surface, shading);
    if (item.wall_normal < 0) return;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    shift[item.wall_normal] = far_side_is_high(view.camera, item.wall_normal) ? item.wall_shift : 0.0;
    item.actor->SetPosition(shift.data());
}

}  // namespace covaria::detail
