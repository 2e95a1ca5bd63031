// SceneRenderer: state of the view, and one picture at a time.
#include "viz/vtk/scene_renderer.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "viz/scene/clear_corner.h"
#include "viz/scene/pick.h"
#include "viz/vtk/layer_actors.h"
#include "viz/vtk/offscreen_window.h"
#include "viz/vtk/overlay.h"
#include "viz/vtk/rendering_log.h"

namespace covaria {
namespace {

constexpr double foot_height = 30.0;  // points, of the caption and the scale bar

}  // namespace

struct SceneRenderer::Implementation {
    vtkNew<vtkRenderer> renderer;
    detail::LayerActors actors{renderer};
    detail::OffscreenWindow window;  // after the renderer: destroyed first, with its context
    detail::TextMasks masks;
    Scene scene;
    std::optional<Scene> realised;  // what the actors show
    ScenePalette palette = ScenePalette::light;
    ScenePalette realised_palette = ScenePalette::light;
    PictureSize size;
    double ratio = 0.0;
    LayerVisibility layers;
    std::string selected;
    MeasureMark measure;
    ScreenRect reserved;
    double covered = 0.0;
    Camera camera;
    bool camera_set = false;

    Implementation();
    double pixel_ratio() const;
    /// All of the scene, clear of the legend, the caption and the scale bar.
    Camera framed(const Camera& looking);
    void realise();
    void aim(double scale, RenderQuality quality);
    Result<Image> draw(RenderQuality quality);
};

namespace {

void add_light(vtkRenderer* renderer, const Eigen::Vector3d& from, double intensity) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(from.x(), from.y(), from.z());
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(intensity);
    renderer->AddLight(light);
}

void set_ground(vtkRenderer* renderer, ScenePalette palette) {
    const detail::Colour top = detail::ground_top(palette), bottom = detail::ground_bottom(palette);
    renderer->SetBackground(bottom.red / 255.0, bottom.green / 255.0, bottom.blue / 255.0);
    renderer->SetBackground2(top.red / 255.0, top.green / 255.0, top.blue / 255.0);
    renderer->GradientBackgroundOn();
}

}  // namespace

SceneRenderer::Implementation::Implementation() {
    detail::redirect_vtk_messages();
    renderer->AutomaticLightCreationOff();
    add_light(renderer, {-0.45, 0.75, 1.0}, 0.85);
    add_light(renderer, {0.9, -0.1, 0.6}, 0.35);
    renderer->SetMaximumNumberOfPeels(4);
    renderer->SetOcclusionRatio(0.0);
    renderer->GetActiveCamera()->ParallelProjectionOn();
}

double SceneRenderer::Implementation::pixel_ratio() const {
    if (ratio > 0) return ratio;
    return std::clamp(std::min(size.width / 1280.0, size.height / 800.0), 0.85, 16.0);
}

Camera SceneRenderer::Implementation::framed(const Camera& looking) {
    const double room = 50.0 * pixel_ratio();  // of an axis' figures and title
    const int foot = std::min(size.height / 4, static_cast<int>(foot_height * pixel_ratio()));
    const PictureSize above{size.width, size.height - foot};
    const SceneBounds bounds = bounds_of(scene);
    const auto lines = detail::head_lines(scene, layers, pixel_ratio(), size.width, masks);
    const Camera clear = clear_of_corner(fitted(looking, bounds, above, room), bounds, above,
                                         detail::legend_ground(lines, pixel_ratio(), masks), room);
    return with_foot(clear, above, foot);
}

void SceneRenderer::Implementation::realise() {
    if (realised && realised_palette == palette && *realised == scene) return;
    const detail::CurrentContext current = window.current();  // actors that go give back their buffers
    const std::lock_guard lock(detail::mesh_mutex());
    const bool comparable = realised && realised_palette == palette;
    actors.update(scene, comparable ? &*realised : nullptr, palette);
    realised = scene;
    realised_palette = palette;
    set_ground(renderer, palette);
}

void SceneRenderer::Implementation::aim(double scale, RenderQuality quality) {
    const bool moving = quality == RenderQuality::moving;
    renderer->SetUseDepthPeeling(!moving);
    renderer->SetUseFXAA(quality == RenderQuality::full);
    const double per_pixel = metres_per_pixel(camera, size) / scale;
    actors.prepare({camera, layers, scale * pixel_ratio(), per_pixel, moving});
    const SceneBounds bounds = bounds_with_meshes(scene);  // nothing is cut off
    const double radius = std::max(1e-9, (bounds.high - bounds.low).norm());
    const double middle = ((bounds.low + bounds.high) / 2 - camera.focal_point).dot(camera.direction);
    const Eigen::Vector3d focal = camera.focal_point - actors.origin();
    const double distance = camera.perspective ? camera.eye_distance() : 2 * radius - middle;
    const Eigen::Vector3d eye = focal - distance * camera.direction;
    vtkCamera* view = renderer->GetActiveCamera();
    view->SetFocalPoint(eye.x() + camera.direction.x(), eye.y() + camera.direction.y(),
                        eye.z() + camera.direction.z());
    view->SetPosition(eye.x(), eye.y(), eye.z());
    view->SetViewUp(camera.up.x(), camera.up.y(), camera.up.z());
    view->SetParallelProjection(!camera.perspective);
    view->SetParallelScale(camera.half_height);
    view->SetViewAngle(2 * std::atan(camera.half_height / camera.eye_distance()) * 180 / std::numbers::pi);
    const double near = std::max(distance + middle - radius, 1e-3 * distance);
    view->SetClippingRange(near, std::max(distance + middle + radius, 2 * near));
}

Result<Image> SceneRenderer::Implementation::draw(RenderQuality quality) {
    if (auto opened = window.open(renderer); !opened) return fail(opened.error());
    realise();
    const bool twice =
        quality == RenderQuality::fine && 2 * std::max(size.width, size.height) <= window.largest_side();
    const int scale = twice ? 2 : 1;
    aim(scale, quality);
    auto image = window.picture(scale * size.width, scale * size.height);
    if (!image) return image;
    if (twice) *image = detail::half_size(*image);
    const detail::OverlayView view{camera,   layers,  palette,  pixel_ratio(),
                                   selected, measure, reserved, covered};
    detail::Overlay(scene, view, *image, masks).paint();
    return image;
}

SceneRenderer::SceneRenderer() : implementation_(std::make_unique<Implementation>()) {}
SceneRenderer::~SceneRenderer() = default;

Result<void> SceneRenderer::open() {
    return implementation_->window.open(implementation_->renderer);
}

void SceneRenderer::set_scene(Scene scene) {
    implementation_->scene = std::move(scene);
    if (!implementation_->camera_set && implementation_->scene.size > 0) set_view(StandardView::iso);
}
const Scene& SceneRenderer::scene() const {
    return implementation_->scene;
}
void SceneRenderer::set_palette(ScenePalette palette) {
    implementation_->palette = palette;
}
void SceneRenderer::set_size(int width, int height) {
    implementation_->size = {std::clamp(width, 1, 16384), std::clamp(height, 1, 16384)};
}
PictureSize SceneRenderer::size() const {
    return implementation_->size;
}
void SceneRenderer::set_pixel_ratio(double ratio) {
    implementation_->ratio = std::isfinite(ratio) ? std::clamp(ratio, 0.0, 16.0) : 0.0;
}
void SceneRenderer::set_layers(const LayerVisibility& layers) {
    implementation_->layers = layers;
}
LayerVisibility SceneRenderer::layers() const {
    return implementation_->layers;
}
void SceneRenderer::set_selected(const std::string& item_id) {
    implementation_->selected = item_id;
}

void SceneRenderer::set_measure(MeasureMark mark) {
    implementation_->measure = std::move(mark);
}
void SceneRenderer::set_reserved(const ScreenRect& rect) {
    implementation_->reserved = rect;
}
void SceneRenderer::set_covered(double height) {
    implementation_->covered = height;
}
const MeasureMark& SceneRenderer::measure() const {
    return implementation_->measure;
}

void SceneRenderer::set_view(StandardView view) {
    Implementation& self = *implementation_;
    self.camera = view_of(bounds_of(self.scene), view, self.size, 0.0, self.camera.perspective);
    fit();
}
void SceneRenderer::fit() {
    set_camera(implementation_->framed(implementation_->camera));
}
void SceneRenderer::set_perspective(bool perspective) {
    implementation_->camera.perspective = perspective;
}
void SceneRenderer::orbit(double dx, double dy) {
    set_camera(orbited(implementation_->camera, implementation_->size, dx, dy));
}
void SceneRenderer::pan(double dx, double dy) {
    set_camera(panned(implementation_->camera, implementation_->size, dx, dy));
}
void SceneRenderer::zoom(double factor) {
    set_camera(zoomed(implementation_->camera, factor));
}
void SceneRenderer::zoom(double factor, Pixel about) {
    set_camera(zoomed(implementation_->camera, factor, implementation_->size, about));
}
Camera SceneRenderer::camera() const {
    return implementation_->camera;
}
void SceneRenderer::set_camera(const Camera& camera) {
    implementation_->camera = camera;
    implementation_->camera_set = true;
}

Result<Image> SceneRenderer::render(RenderQuality quality) {
    return implementation_->draw(quality);
}

std::optional<std::string> SceneRenderer::pick(double x, double y) const {
    const Implementation& self = *implementation_;
    return pick_item(
        self.scene, self.camera, self.size, {x, y}, [&](Layer layer) { return self.layers[layer]; },
        6.0 * self.pixel_ratio());
}
Pixel SceneRenderer::project(const Eigen::Vector3d& p_W) const {
    return covaria::project(implementation_->camera, implementation_->size, p_W);
}
Eigen::Vector3d SceneRenderer::world_at(double x, double y, const Eigen::Vector3d& through_W) const {
    return covaria::world_at(implementation_->camera, implementation_->size, {x, y}, through_W);
}

}  // namespace covaria
