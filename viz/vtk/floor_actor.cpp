// The floor: its colour fades into the ground, with the shadow of what stands on it.
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>

#include "viz/scene/contact_shadow.h"
#include "viz/vtk/layer_actors.h"

namespace covaria::detail {
namespace {

constexpr double fades_from = 0.3;  // part of half of its side; it is gone at the edge
constexpr double below = 2e-4;      // part of the scene's size, so that no foot is in its plane

vtkSmartPointer<vtkTexture> texture_of(const ContactShadow& shadow, ScenePalette palette) {
    const int n = static_cast<int>(shadow.cells);
    vtkNew<vtkImageData> image;
    image->SetDimensions(n, n, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
    const Colour ground = ground_colour(palette), floor = floor_colour(palette);
    const double strength = palette == ScenePalette::light ? 1.0 : 1.5;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const double r = std::hypot(2.0 * i / (n - 1) - 1, 2.0 * j / (n - 1) - 1);
            const double t = std::clamp((1.0 - r) / (1.0 - fades_from), 0.0, 1.0);
            const double part = t * t * (3 - 2 * t);
            const float dark =
                shadow.darkness[static_cast<std::size_t>(j) * shadow.cells + static_cast<std::size_t>(i)];
            const double light =
                1.0 - std::min(0.8, strength * static_cast<double>(dark)) * std::min(1.0, 4 * part);
            const auto mixed = [&](std::uint8_t a, std::uint8_t b) {
                return static_cast<unsigned char>(std::lround(light * (a + part * (b - a))));
            };
            *pixel++ = mixed(ground.red, floor.red);
            *pixel++ = mixed(ground.green, floor.green);
            *pixel++ = mixed(ground.blue, floor.blue);
        }
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(image);
    texture->InterpolateOn();
    return texture;
}

}  // namespace

std::vector<LayerActor> floor_actors(const Scene& scene, const Eigen::Vector3d& origin,
                                     ScenePalette palette) {
    const ContactShadow shadow = contact_shadow(scene);
    if (shadow.cells == 0) return {};
    const Eigen::Vector3d corner =
        shadow.middle - origin - Eigen::Vector3d(shadow.half, shadow.half, below * scene.size);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(corner.x(), corner.y(), corner.z());
    plane->SetPoint1(corner.x() + 2 * shadow.half, corner.y(), corner.z());
    plane->SetPoint2(corner.x(), corner.y() + 2 * shadow.half, corner.z());
    plane->Update();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(plane->GetOutput());
    LayerActor made{vtkSmartPointer<vtkActor>::New()};
    made.actor->SetMapper(mapper);
    made.actor->SetTexture(texture_of(shadow, palette));
    made.actor->GetProperty()->LightingOff();
    made.actor->GetProperty()->BackfaceCullingOn();  // from below it hides nothing
    made.is_floor = true;
    return {made};
}

}  // namespace covaria::detail
