// Actors of a map: spheres in colours, ways between them, and iso-surfaces of a grid in space.
#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <numbers>

#include "viz/vtk/layer_actors.h"
#include "viz/vtk/shapes.h"

namespace covaria::detail {
namespace {

constexpr double surface_opacity = 0.38;

bool is_known(const SceneMap& map, std::size_t i) {
    return std::isfinite(map.values[i]) && map.positions[i].allFinite();
}

Colour colour_at(const SceneMap& map, double value) {
    return magnitude_colour(map.high > map.low ? (value - map.low) / (map.high - map.low) : 0.5);
}

bool is_marked(const SceneMap& map, std::size_t i) {
    return i < map.marked.size() && map.marked[i];
}

/// Points that are not marked.
vtkSmartPointer<vtkPolyData> coloured_points(const SceneMap& map, const Eigen::Vector3d& origin) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    colours->SetName("colours");
    for (std::size_t i = 0; i < map.positions.size(); ++i) {
        if (!is_known(map, i) || !map.shown[i] || is_marked(map, i)) continue;
        const Eigen::Vector3d p = map.positions[i] - origin;
        points->InsertNextPoint(p.x(), p.y(), p.z());
        const Colour colour = colour_at(map, map.values[i]);
        const unsigned char rgb[3] = {colour.red, colour.green, colour.blue};
        colours->InsertNextTypedTuple(rgb);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->GetPointData()->SetScalars(colours);
    return data;
}

LayerActor points_actor(const SceneMap& map, const Eigen::Vector3d& origin) {
    constexpr vtkIdType smooth_limit = 3000;  // more points are drawn with fewer facets
    const auto data = coloured_points(map, origin);
    vtkNew<vtkSphereSource> sphere;
    const int facets = data->GetNumberOfPoints() > smooth_limit ? 6 : 14;
    sphere->SetThetaResolution(facets);
    sphere->SetPhiResolution(facets);
    sphere->SetRadius(map.radius);
    vtkNew<vtkGlyph3D> glyphs;
    glyphs->SetInputData(data);
    glyphs->SetSourceConnection(sphere->GetOutputPort());
    glyphs->SetScaleModeToDataScalingOff();
    glyphs->SetColorModeToColorByScalar();
    glyphs->Update();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(glyphs->GetOutput());
    mapper->SetStatic(true);
    LayerActor made{vtkSmartPointer<vtkActor>::New()};
    made.actor->SetMapper(mapper);
    made.actor->GetProperty()->SetAmbient(0.25);
    made.actor->GetProperty()->SetDiffuse(0.75);
    return made;
}

/// Cells whose eight corners have values: a surface ends where nothing is known.
vtkSmartPointer<vtkUnstructuredGrid> known_cells(const SceneMap& map, const Eigen::Vector3d& origin) {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> values;
    for (std::size_t i = 0; i < map.positions.size(); ++i) {
        const Eigen::Vector3d p = is_known(map, i) ? Eigen::Vector3d(map.positions[i] - origin)
                                                   : Eigen::Vector3d(Eigen::Vector3d::Zero());
        points->InsertNextPoint(p.x(), p.y(), p.z());
        values->InsertNextValue(is_known(map, i) ? map.values[i] : 0.0);
    }
    grid->SetPoints(points);
    grid->GetPointData()->SetScalars(values);
    const auto at = [&](std::size_t i, std::size_t j, std::size_t k) {
        return (i * map.grid[1] + j) * map.grid[2] + k;
    };
    for (std::size_t i = 0; i + 1 < map.grid[0]; ++i)
        for (std::size_t j = 0; j + 1 < map.grid[1]; ++j)
            for (std::size_t k = 0; k + 1 < map.grid[2]; ++k) {
                const std::size_t corners[8] = {
                    at(i, j, k),     at(i + 1, j, k),     at(i + 1, j + 1, k),     at(i, j + 1, k),
                    at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)};
                vtkIdType ids[8];
                bool known = true;
                for (int c = 0; c < 8; ++c) {
                    ids[c] = static_cast<vtkIdType>(corners[c]);
                    known = known && is_known(map, corners[c]);
                }
                if (known) grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
            }
    return grid;
}

void add_surfaces(const SceneMap& map, const Eigen::Vector3d& origin, std::vector<LayerActor>& actors) {
    if (map.levels.empty()) return;
    const auto grid = known_cells(map, origin);
    for (const double level : map.levels) {
        vtkNew<vtkContourFilter> contour;
        contour->SetInputData(grid);
        contour->SetValue(0, level);
        contour->ComputeScalarsOff();
        contour->ComputeNormalsOff();
        vtkNew<vtkPolyDataNormals> normals;
        normals->SetInputConnection(contour->GetOutputPort());
        normals->SplittingOff();
        normals->Update();
        if (normals->GetOutput()->GetNumberOfCells() == 0) continue;
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(normals->GetOutput());
        mapper->ScalarVisibilityOff();
        mapper->SetStatic(true);
        LayerActor made{vtkSmartPointer<vtkActor>::New()};
        made.actor->SetMapper(mapper);
        const Colour colour = colour_at(map, level);
        made.actor->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
        made.actor->GetProperty()->SetOpacity(surface_opacity);
        made.actor->GetProperty()->SetAmbient(0.45);  // equally bright from behind
        made.actor->GetProperty()->SetDiffuse(0.55);
        actors.push_back(std::move(made));
    }
}

/// Marked points in their rings, and the ways.
void add_marks(const SceneMap& map, const Eigen::Vector3d& origin, ScenePalette palette,
               std::vector<LayerActor>& actors) {
    constexpr double marked_size = 1.6, ring_size = 1.5;  // multiples of the inner size
    constexpr int ring_steps = 36;
    Shapes solids(origin), rings(origin);
    for (const auto& [from, to] : map.ways)
        if (is_known(map, from) && is_known(map, to))
            solids.cylinder(map.positions[from], map.positions[to], map.way_radius,
                            colour_at(map, map.values[to]));
    for (std::size_t i = 0; i < map.positions.size(); ++i) {
        if (!is_known(map, i) || !map.shown[i] || !is_marked(map, i)) continue;
        const Eigen::Vector3d& centre = map.positions[i];
        const double radius = marked_size * map.radius;
        solids.sphere(centre, radius, colour_at(map, map.values[i]));
        for (int plane = 0; plane < 3; ++plane) {
            std::vector<Eigen::Vector3d> ring;
            for (int k = 0; k <= ring_steps; ++k) {
                const double t = 2.0 * std::numbers::pi * k / ring_steps;
                ring.push_back(centre + ring_size * radius *
                                            (std::cos(t) * Eigen::Vector3d::Unit(plane) +
                                             std::sin(t) * Eigen::Vector3d::Unit((plane + 1) % 3)));
            }
            rings.line(ring, colour_of(Role::text, palette));
        }
    }
    if (auto actor = solids.solid_actor()) actors.push_back({actor});
    if (auto actor = rings.line_actor()) actors.push_back({actor, 1.1});
}

}  // namespace

std::vector<LayerActor> map_actors(const Scene& scene, const Eigen::Vector3d& origin, ScenePalette palette) {
    std::vector<LayerActor> actors;
    if (!scene.map || scene.map->positions.empty()) return actors;
    actors.push_back(points_actor(*scene.map, origin));
    add_surfaces(*scene.map, origin, actors);
    add_marks(*scene.map, origin, palette, actors);
    return actors;
}

}  // namespace covaria::detail
