// Actors of clouds: one point per trial, and a thinned twin for moving pictures.
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "viz/vtk/layer_actors.h"

namespace covaria::detail {
namespace {

constexpr std::size_t moving_limit = 12'000;  // points of all clouds together while the camera moves
constexpr double point_size = 1.5;

vtkSmartPointer<vtkPolyData> points_of(const SceneCloud& cloud, std::size_t stride) {
    const std::size_t count = (cloud.size() + stride - 1) / stride;
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(count));
    float* to = coordinates->GetPointer(0);
    for (std::size_t i = 0; i < count; ++i) to = std::copy_n(&cloud.offsets[3 * i * stride], 3, to);
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    vtkNew<vtkCellArray> cell;  // one cell of many points
    std::vector<vtkIdType> ids(count);
    std::iota(ids.begin(), ids.end(), vtkIdType{0});
    cell->InsertNextCell(static_cast<vtkIdType>(count), ids.data());
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetVerts(cell);
    return data;
}

/// 1.5 times the root mean square of the distances: holds about 90 % of a normal cloud.
double radius_of(const SceneCloud& cloud) {
    double sum = 0.0;
    for (const float offset : cloud.offsets) sum += static_cast<double>(offset) * static_cast<double>(offset);
    return 1.5 * std::sqrt(sum / static_cast<double>(cloud.size()));
}

LayerActor cloud_actor(const SceneCloud& cloud, const Eigen::Vector3d& origin, ScenePalette palette,
                       std::size_t stride) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(points_of(cloud, stride));
    mapper->SetStatic(true);
    LayerActor made{vtkSmartPointer<vtkActor>::New()};
    made.point_size = point_size;
    made.cloud_points = static_cast<double>((cloud.size() + stride - 1) / stride);
    made.cloud_radius = radius_of(cloud);
    made.actor->SetMapper(mapper);
    const Eigen::Vector3d at = cloud.item.position - origin;
    made.actor->SetPosition(at.x(), at.y(), at.z());
    const Colour colour = colour_of(cloud.role, palette);
    vtkProperty* property = made.actor->GetProperty();
    property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
    property->LightingOff();
    // Blended in the order of the trials and with depth: near trials hide far ones, a dense middle does not
    // saturate, and sorting translucent surfaces need not peel through thousands of points.
    made.actor->ForceOpaqueOn();
    return made;
}

}  // namespace

std::vector<LayerActor> cloud_actors(const Scene& scene, const Eigen::Vector3d& origin,
                                     ScenePalette palette) {
    std::size_t total = 0;
    for (const SceneCloud& cloud : scene.clouds) total += cloud.size();
    const std::size_t stride = (total + moving_limit - 1) / moving_limit;
    std::vector<LayerActor> actors;
    for (const SceneCloud& cloud : scene.clouds) {
        if (cloud.size() == 0) continue;
        actors.push_back(cloud_actor(cloud, origin, palette, 1));
        if (stride <= 1) continue;
        actors.back().shown = LayerActor::Shown::still;
        actors.push_back(cloud_actor(cloud, origin, palette, stride));
        actors.back().shown = LayerActor::Shown::moving;
    }
    return actors;
}

}  // namespace covaria::detail
