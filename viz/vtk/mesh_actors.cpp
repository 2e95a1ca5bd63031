// Actors of context meshes: translucent, flat-shaded, seen from both sides.
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

#include "viz/vtk/layer_actors.h"

namespace covaria::detail {
namespace {

vtkSmartPointer<vtkPolyData> surface_of(const TriangleMesh& mesh) {
    const auto corners = 3 * static_cast<vtkIdType>(mesh.triangles());
    vtkNew<vtkPoints> points;  // single precision
    points->SetNumberOfPoints(corners);
    std::copy(mesh.corners.begin(), mesh.corners.end(), static_cast<float*>(points->GetVoidPointer(0)));
    vtkNew<vtkTypeInt32Array> offsets, ids;
    offsets->SetNumberOfValues(corners / 3 + 1);
    for (vtkIdType i = 0; i <= corners / 3; ++i) offsets->SetValue(i, static_cast<int>(3 * i));
    ids->SetNumberOfValues(corners);
    std::iota(ids->GetPointer(0), ids->GetPointer(0) + corners, 0);
    vtkNew<vtkCellArray> triangles;
    triangles->SetData(offsets, ids);
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    return surface;
}

/// Made once for each mesh that is still there. Under mesh_mutex, as all building of meshes.
vtkSmartPointer<vtkPolyData> shared_surface(const std::shared_ptr<const TriangleMesh>& mesh) {
    struct Made {
        std::weak_ptr<const TriangleMesh> of;
        vtkSmartPointer<vtkPolyData> surface;
    };
    static std::map<const TriangleMesh*, Made> made;
    std::erase_if(made, [](const auto& each) { return each.second.of.expired(); });
    Made& found = made[mesh.get()];
    if (!found.surface) found = {mesh, surface_of(*mesh)};
    return found.surface;
}

/// Maps the mesh's own coordinates to W relative to `origin`.
vtkSmartPointer<vtkMatrix4x4> placement_of(const SceneMesh& mesh, const Eigen::Vector3d& origin) {
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    const Eigen::Matrix3d linear = mesh.scale * mesh.X_WM.linear();
    const Eigen::Vector3d at = mesh.X_WM.translation() - origin;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, linear(row, column));
        matrix->SetElement(row, 3, at[row]);
    }
    return matrix;
}

}  // namespace

std::vector<LayerActor> mesh_actors(const Scene& scene, const Eigen::Vector3d& origin, ScenePalette palette) {
    std::vector<LayerActor> actors;
    for (const SceneMesh& mesh : scene.meshes) {
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(shared_surface(mesh.triangles));
        mapper->ScalarVisibilityOff();
        auto actor = vtkSmartPointer<vtkActor>::New();
        actor->SetMapper(mapper);
        actor->SetUserMatrix(placement_of(mesh, origin));
        const Colour colour = colour_of(mesh.colour, palette);
        vtkProperty* property = actor->GetProperty();
        property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
        property->SetOpacity(mesh.opacity);
        property->SetInterpolationToFlat();
        property->SetAmbient(0.25);
        property->SetDiffuse(0.75);
        if (mesh.opacity < 1.0) actor->ForceTranslucentOn();
        actors.push_back({actor});
    }
    return actors;
}

}  // namespace covaria::detail
