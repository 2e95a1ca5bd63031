// SceneRenderer: state of the view, and one picture at a time.
#include "viz/vtk/scene_renderer.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numbers>

#include "viz/scene/clear_corner.h"
#include "viz/scene/framing.h"
#include "viz/scene/pick.h"
#include "viz/scene/section.h"
#include "viz/vtk/layer_actors.h"
#include "viz/vtk/offscreen_window.h"
#include "viz/vtk/overlay.h"
#include "viz/vtk/rendering_log.h"

namespace covaria {
namespace {

constexpr double foot_height = 30.0;  // points, of the caption and the scale bar

/// Whether pictures of the window have ambient occlusion. It is tried once in a process, with a picture that
/// is large enough to tell, and stays where a picture with it takes no longer than `longest`.
enum class Occlusion { untried, kept, left_out };
std::atomic<Occlusion> occlusion_in_window = Occlusion::untried;
constexpr std::chrono::milliseconds longest{50};
constexpr int telling_size = 300'000;  // pixels

}  // namespace

struct SceneRenderer::Implementation {
    vtkNew<vtkRenderer> renderer;
    detail::LayerActors actors{renderer};
    detail::OffscreenWindow window;  // after the renderer: destroyed first, with its context
    detail::TextMasks masks;
    Scene scene;
    std::optional<Scene> marked;    // what a section leaves of it for words and marks
    std::optional<Scene> realised;  // the scene that the actors show
    ScenePalette palette = ScenePalette::light;
    ScenePalette realised_palette = ScenePalette::light;
    PictureSize size;
    double ratio = 0.0;
    LayerVisibility layers;
    std::string selected, pointed;
    MeasureMark measure;
    ScreenRect reserved;
    double covered = 0.0;
    Camera camera;
    bool camera_set = false;

    Implementation();
    double pixel_ratio() const;
    /// The camera that has the whole scene clear of the legend, the caption and the scale bar.
    Camera framed(const Camera& looking);
    void realise();
    void aim(const Camera& looking, PictureSize drawn, double scale, RenderQuality quality);
    /// Draws the picture without words; `drawn` in pixels of it.
    Result<Image> bare(const Camera& looking, PictureSize drawn, RenderQuality quality);
    /// Paints the whole into a corner, where the camera looks at a part of it; its place.
    ScreenRect add_inset(Image& image, RenderQuality quality);
    void set_occlusion(bool shown, RenderQuality quality);
    /// Draws twice, the second time by the clock: shaders are compiled the first time.
    void try_occlusion();
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
    const detail::Colour ground = detail::ground_colour(palette);
    renderer->SetBackground(ground.red / 255.0, ground.green / 255.0, ground.blue / 255.0);
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
    const double room = (layers[Layer::axes] ? 50.0 : 28.0) * pixel_ratio();  // for figures and titles
    const int foot = std::min(size.height / 4, static_cast<int>(foot_height * pixel_ratio()));
    const PictureSize above{size.width, size.height - foot};
    const SceneBounds bounds = scene.focus && !layers[Layer::axes] ? *scene.focus : bounds_of(scene);
    const auto lines = detail::head_lines(scene, layers, pixel_ratio(), size.width, masks);
    if (!looking.perspective && !layers[Layer::axes]) {
        const ScreenRect head = detail::legend_ground(lines, pixel_ratio(), masks);
        const double side = std::min(0.07 * size.width, 2 * room), top = head.y + head.height + room / 2;
        const ScreenRect inside{side, top, size.width - 2 * side,
                                std::max(0.4 * size.height, size.height - top - foot - room)};
        Camera middle = looking;
        middle.focal_point = (bounds.low + bounds.high) / 2;
        return scene.focus ? filling(middle, bounds, size, inside) : filling(middle, scene, size, inside);
    }
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

void SceneRenderer::Implementation::aim(const Camera& looking, PictureSize drawn, double scale,
                                        RenderQuality quality) {
    const bool moving = quality == RenderQuality::moving;
    renderer->SetUseDepthPeeling(!moving);
    renderer->SetUseFXAA(quality == RenderQuality::full);
    const double per_pixel = metres_per_pixel(looking, drawn) / scale;
    actors.prepare({looking,
                    layers,
                    scale * pixel_ratio(),
                    per_pixel,
                    moving,
                    {static_cast<int>(scale) * drawn.width, static_cast<int>(scale) * drawn.height},
                    scene.section});
    const SceneBounds bounds = bounds_with_meshes(scene);  // nothing is cut off
    const double radius = std::max(1e-9, (bounds.high - bounds.low).norm());
    const double middle = ((bounds.low + bounds.high) / 2 - looking.focal_point).dot(looking.direction);
    const Eigen::Vector3d focal = looking.focal_point - actors.origin();
    const double distance = looking.perspective ? looking.eye_distance() : 2 * radius - middle;
    const Eigen::Vector3d eye = focal - distance * looking.direction;
    vtkCamera* view = renderer->GetActiveCamera();
    view->SetFocalPoint(eye.x() + looking.direction.x(), eye.y() + looking.direction.y(),
                        eye.z() + looking.direction.z());
    view->SetPosition(eye.x(), eye.y(), eye.z());
    view->SetViewUp(looking.up.x(), looking.up.y(), looking.up.z());
    view->SetParallelProjection(!looking.perspective);
    view->SetParallelScale(looking.half_height);
    view->SetViewAngle(2 * std::atan(looking.half_height / looking.eye_distance()) * 180 / std::numbers::pi);
    const double near = std::max(distance + middle - radius, 1e-3 * distance);
    view->SetClippingRange(near, std::max(distance + middle + radius, 2 * near));
}

void SceneRenderer::Implementation::set_occlusion(bool shown, RenderQuality quality) {
    constexpr double reach = 0.045, bias = 0.0025;  // parts of the scene's size
    renderer->SetUseSSAO(shown && scene.size > 0);
    renderer->SetSSAORadius(reach * scene.size);
    renderer->SetSSAOBias(bias * scene.size);
    renderer->SetSSAOKernelSize(quality == RenderQuality::fine ? 128 : 32);
    renderer->SetSSAOBlur(true);
}

void SceneRenderer::Implementation::try_occlusion() {
    if (occlusion_in_window != Occlusion::untried || !(scene.size > 0) ||
        size.width * size.height < telling_size)
        return;
    aim(camera, size, 1.0, RenderQuality::full);
    set_occlusion(true, RenderQuality::full);
    std::chrono::steady_clock::duration taken{};
    for (int i = 0; i < 2; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        if (!window.picture(size.width, size.height)) return;
        taken = std::chrono::steady_clock::now() - begin;
    }
    occlusion_in_window = taken <= longest ? Occlusion::kept : Occlusion::left_out;
}

Result<Image> SceneRenderer::Implementation::draw(RenderQuality quality) {
    if (auto opened = window.open(renderer); !opened) return fail(opened.error());
    realise();
    if (quality == RenderQuality::full) try_occlusion();
    set_occlusion(quality == RenderQuality::fine ||
                      (quality == RenderQuality::full && occlusion_in_window == Occlusion::kept),
                  quality);
    auto image = bare(camera, size, quality);
    if (!image) return image;
    const ScreenRect inset = add_inset(*image, quality);
    const detail::OverlayView view{camera,  layers,  palette,  pixel_ratio(), selected,
                                   pointed, measure, reserved, covered,       inset};
    detail::Overlay(marked ? *marked : scene, view, *image, masks).paint();
    return image;
}

Result<Image> SceneRenderer::Implementation::bare(const Camera& looking, PictureSize drawn,
                                                  RenderQuality quality) {
    const bool twice =
        quality == RenderQuality::fine && 2 * std::max(drawn.width, drawn.height) <= window.largest_side();
    const int scale = twice ? 2 : 1;
    aim(looking, drawn, scale, quality);
    auto image = window.picture(scale * drawn.width, scale * drawn.height);
    if (image && twice) *image = detail::half_size(*image);
    return image;
}

ScreenRect SceneRenderer::Implementation::add_inset(Image& image, RenderQuality quality) {
    constexpr double width = 168.0, height = 104.0, margin = 16.0, above_scale_bar = 44.0;  // points
    constexpr double largest_part = 0.25;                                                   // of a picture
    const double unit = pixel_ratio();
    const PictureSize small{static_cast<int>(width * unit), static_cast<int>(height * unit)};
    if (!scene.focus || quality == RenderQuality::moving || small.width > largest_part * size.width ||
        small.height > largest_part * size.height)
        return {};
    const Camera whole = fitted(camera, bounds_of(scene), small, 4 * unit);
    if (metres_per_pixel(camera, size) * size.width > 0.8 * metres_per_pixel(whole, small) * small.width)
        return {};  // there is nothing more to be seen in it
    const auto inset = bare(whole, small, quality);
    if (!inset) return {};
    const int left = size.width - small.width - static_cast<int>(margin * unit);
    const int top = size.height - small.height - static_cast<int>(covered + above_scale_bar * unit);
    for (int y = 0; y < small.height; ++y)
        std::copy_n(&inset->rgba[4 * std::size_t(y) * std::size_t(small.width)], 4 * small.width,
                    &image.rgba[4 * (std::size_t(top + y) * std::size_t(size.width) + std::size_t(left))]);
    return {double(left), double(top), double(small.width), double(small.height)};
}

SceneRenderer::SceneRenderer() : implementation_(std::make_unique<Implementation>()) {}
SceneRenderer::~SceneRenderer() = default;

Result<void> SceneRenderer::open() {
    return implementation_->window.open(implementation_->renderer);
}

void SceneRenderer::set_scene(Scene scene) {
    implementation_->scene = std::move(scene);
    implementation_->marked.reset();
    if (implementation_->scene.section) implementation_->marked = left_by_section(implementation_->scene);
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

void SceneRenderer::set_pointed(const std::string& item_id) {
    implementation_->pointed = item_id;
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
