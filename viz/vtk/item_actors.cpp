// Actors of frames, points, bodies, links, vectors and ellipsoids.
#include <vtkProperty.h>

#include <Eigen/LU>
#include <algorithm>

#include "viz/scene/section.h"
#include "viz/vtk/layer_actors.h"
#include "viz/vtk/shapes.h"

namespace covaria::detail {
namespace {

using Vector = Eigen::Vector3d;

constexpr double ellipsoid_opacity = 0.30;
constexpr double before_opacity = 0.16;
constexpr double sight_opacity = 0.34;
constexpr double edge_width = 1.1;
constexpr std::size_t most_smooth = 400;  // solids of a layer; more have fewer corners

/// Shapes of one layer, collected by sort.
struct Parts {
    Parts(const Vector& origin, ScenePalette used)
        : solids(origin), clear(origin), paths(origin), lines(origin), dashes(origin), palette(used) {}
    Colour colour(Role role) const { return colour_of(role, palette); }
    void add(const std::vector<Solid>& made) {
        if (made.size() > most_smooth) solids.set_coarse(true);
        for (const Solid& solid : made)
            (solid.opacity < 1.0 ? paths : solids).solid(solid, colour_of(solid.material, palette));
    }
    std::vector<LayerActor> actors(double line_width = edge_width) const {
        std::vector<LayerActor> made;
        const auto take = [&](const vtkSmartPointer<vtkActor>& actor, double width,
                              std::optional<Surface> surface) {
            if (!actor) return;
            made.push_back({actor, width});
            made.back().surface = surface;
        };
        take(solids.solid_actor(), 0.0, Surface::matt);
        take(clear.clear_actor(), 0.0, Surface::clear);
        if (auto actor = paths.solid_actor()) {
            actor->ForceTranslucentOn();
            take(actor, 0.0, Surface::matt);
        }
        take(lines.line_actor(), line_width, {});
        if (auto actor = dashes.dashed_actor()) {
            actor->ForceTranslucentOn();
            take(actor, 1.0, Surface::dashed);
        }
        return made;
    }
    Shapes solids, clear, paths, lines, dashes;
    ScenePalette palette;
};

void add_frames(const Scene& scene, Parts& parts) {
    static constexpr Role roles[] = {Role::axis_x, Role::axis_y, Role::axis_z};
    for (const SceneFrame& frame : scene.frames) {
        const Vector& o = frame.item.position;
        for (int i = 0; i < 3; ++i)
            parts.solids.arrow(o, o + frame.length * frame.R_WF.col(i), 0.022 * frame.length,
                               parts.colour(roles[i]));
        parts.solids.sphere(o, 0.05 * frame.length, parts.colour(Role::point));
    }
}

/// A moment has two heads, one behind the other.
void add_vectors(const Scene& scene, Parts& parts) {
    for (const SceneVector& v : scene.vectors) {
        const bool moment = v.kind == VectorKind::moment;
        const Colour colour = parts.colour(moment ? Role::moment : Role::vector);
        const Vector tip = v.item.position + v.arrow;
        parts.solids.arrow(v.item.position, tip, v.radius, colour);
        const double head = 5.0 * v.radius;
        if (moment && v.arrow.norm() > 3.0 * head)
            parts.solids.arrow(v.item.position, tip - head * v.arrow.normalized(), v.radius, colour);
    }
}

void add_lines(const Scene& scene, Parts& parts) {
    for (const SceneLink& link : scene.links) {
        const auto left = left_of_line(scene, link.from, link.to);
        if (link.radius > 0 || !left) continue;
        const std::vector<Vector> line(left->begin(), left->end());
        const bool seeing = link.kind == LinkKind::sight_line || link.kind == LinkKind::field_of_view;
        const Colour colour = parts.colour(link.is_doubtful ? Role::not_met
                                           : seeing         ? Role::sight_line
                                                            : Role::link);
        const double opacity = link.is_doubtful                       ? 1.0
                               : link.kind == LinkKind::field_of_view ? 0.5 * sight_opacity
                                                                      : sight_opacity;
        if (link.is_dashed)
            parts.dashes.line(line, colour, seeing ? opacity : 2 * sight_opacity);
        else
            parts.lines.line(line, colour, seeing ? opacity : 1.0);
    }
}

/// Whether an output's ellipsoid covers the input's point: nothing could be told apart there.
bool is_within_an_output(const SceneEllipsoid& input, const std::vector<const SceneEllipsoid*>& outputs) {
    return std::ranges::any_of(outputs, [&](const SceneEllipsoid* output) {
        const Vector away = input.item.position - output->item.position;
        return (output->axes.inverse() * away).norm() < 1.0;
    });
}

void add_ellipsoids(const std::vector<SceneEllipsoid>& ellipsoids, double opacity, Parts& parts) {
    std::vector<const SceneEllipsoid*> outputs;
    for (const SceneEllipsoid& ellipsoid : ellipsoids)
        if (ellipsoid.role == Role::output && ellipsoid.rank == 3) outputs.push_back(&ellipsoid);
    for (const SceneEllipsoid& ellipsoid : ellipsoids) {
        if (ellipsoid.role == Role::input && is_within_an_output(ellipsoid, outputs)) continue;
        const Colour colour = parts.colour(ellipsoid.role);
        Eigen::Matrix3d axes = ellipsoid.axes;
        // A flat region has no third axis: give it a thin body so that it is seen from every side.
        const double thin = 0.01 * axes.col(0).norm();
        if (ellipsoid.rank < 2) axes.col(1) = thin * axes.col(0).unitOrthogonal();
        if (ellipsoid.rank < 3) axes.col(2) = thin * axes.col(0).cross(axes.col(1)).normalized();
        parts.clear.ellipsoid(ellipsoid.item.position, axes, colour, opacity);
    }
}

}  // namespace

std::vector<LayerActor> actors_of(Layer layer, const Scene& scene, const Vector& origin,
                                  ScenePalette palette) {
    Parts parts(origin, palette);
    switch (layer) {
        case Layer::frames:
            add_frames(scene, parts);
            break;
        case Layer::points:
            parts.add(solids_of_points(scene));
            break;
        case Layer::bodies:
            parts.add(solids_of_bodies(scene));
            break;
        case Layer::links:
            parts.add(solids_of_links(scene));
            add_lines(scene, parts);
            break;
        case Layer::vectors:
            add_vectors(scene, parts);
            break;
        case Layer::ellipsoids:
            add_ellipsoids(scene.ellipsoids, ellipsoid_opacity, parts);
            break;
        case Layer::ellipsoids_before:
            add_ellipsoids(scene.ellipsoids_before, before_opacity, parts);
            break;
        case Layer::clouds:
            return cloud_actors(scene, origin, palette);
        case Layer::wall_histograms:
            return histogram_actors(scene, origin, palette);
        case Layer::axes:
            return axes_actors(scene, origin, palette);
        case Layer::map:
            return map_actors(scene, origin, palette);
        case Layer::meshes:
            return mesh_actors(scene, origin, palette);
        case Layer::labels:
        case Layer::legend:
            return {};
    }
    return parts.actors();
}

}  // namespace covaria::detail
