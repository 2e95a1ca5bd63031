// Actors of frames, points, bodies, links, vectors and ellipsoids.
#include <vtkProperty.h>

#include <algorithm>

#include "viz/vtk/layer_actors.h"
#include "viz/vtk/shapes.h"

namespace covaria::detail {
namespace {

using Vector = Eigen::Vector3d;

constexpr double plate_opacity = 0.42;
constexpr double ellipsoid_opacity = 0.30;
constexpr double before_opacity = 0.12;  // mostly its sections: what is now is seen through it
constexpr double edge_width = 1.1;

/// What is collected for one layer.
struct Parts {
    Parts(const Vector& origin, ScenePalette used)
        : solids(origin), clear(origin), lines(origin), palette(used) {}
    Colour colour(Role role) const { return colour_of(role, palette); }
    std::vector<LayerActor> actors(double line_width = edge_width) const {
        std::vector<LayerActor> made;
        if (auto actor = solids.solid_actor()) made.push_back({actor});
        if (auto actor = clear.solid_actor()) {
            actor->ForceTranslucentOn();
            actor->GetProperty()->BackfaceCullingOn();
            made.push_back({actor});
        }
        if (auto actor = lines.line_actor()) made.push_back({actor, line_width});
        return made;
    }
    Shapes solids, clear, lines;
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

void add_points(const Scene& scene, Parts& parts) {
    for (const ScenePoint& point : scene.points) {
        const Vector& p = point.item.position;
        const double r = point.radius;
        const Colour colour = parts.colour(Role::point);
        switch (point.kind) {
            case PointKind::nest:  // a ball in its seat
                parts.solids.sphere(p, r, colour);
                parts.solids.cylinder(p - 0.75 * r * point.axis, p - 0.1 * r * point.axis, 1.25 * r,
                                      parts.colour(Role::body));
                break;
            case PointKind::support:
                parts.solids.cone(p - 2.2 * r * point.axis, p, 1.2 * r, colour);
                break;
            case PointKind::flange:
                parts.solids.cylinder(p - 0.3 * r * point.axis, p + 0.3 * r * point.axis, 1.8 * r, colour);
                break;
            case PointKind::tool:
                parts.solids.cone(p + 2.6 * r * point.axis, p, 0.9 * r, colour);
                break;
            case PointKind::station:
                parts.solids.box(p, Eigen::AngleAxisd(0.785398, Vector::UnitZ()).toRotationMatrix(),
                                 Vector::Constant(1.5 * r), colour);
                break;
            default:
                parts.solids.sphere(p, r, colour);
        }
    }
}

/// Glyphs, drawn with modest means: what matters is where the instrument stands and looks.
void add_glyph(const SceneBody& body, Parts& parts) {
    const Vector& p = body.item.position;
    const Vector sight = body.R_WB.col(0), across = body.R_WB.col(1), up = body.R_WB.col(2);
    const double s = body.size;
    const Colour colour = parts.colour(Role::instrument), pale = parts.colour(Role::body);
    if (body.kind == BodyKind::force_sensor) {
        parts.solids.cylinder(p - 0.16 * s * up, p + 0.16 * s * up, 0.34 * s, colour);
        parts.solids.cylinder(p - 0.2 * s * up, p + 0.2 * s * up, 0.22 * s, pale);
    } else if (body.glyph == "camera") {
        parts.solids.box(p - 0.16 * s * sight, body.R_WB, {0.32 * s, 0.46 * s, 0.36 * s}, colour);
        parts.solids.cylinder(p, p + 0.22 * s * sight, 0.14 * s, pale);
    } else if (body.glyph == "distance-meter") {
        parts.solids.box(p - 0.28 * s * sight, body.R_WB, {0.56 * s, 0.26 * s, 0.22 * s}, colour);
        parts.solids.cylinder(p, p + 0.08 * s * sight, 0.08 * s, pale);
    } else {  // total station, tracker: a foot, a fork and a head that looks
        parts.solids.cylinder(p - 0.5 * s * up, p - 0.34 * s * up, 0.26 * s, pale);
        parts.solids.box(p - 0.3 * s * up, body.R_WB, {0.24 * s, 0.52 * s, 0.1 * s}, colour);
        for (double side : {-1.0, 1.0})
            parts.solids.box(p + side * 0.22 * s * across - 0.06 * s * up, body.R_WB,
                             {0.2 * s, 0.08 * s, 0.5 * s}, colour);
        if (body.glyph == "tracker") parts.solids.sphere(p, 0.19 * s, colour);
        parts.solids.cylinder(p - 0.2 * s * sight, p + 0.28 * s * sight, 0.11 * s, pale);
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

void add_outline(std::vector<Vector> corners, const Vector& shift, Shapes& lines, Colour colour) {
    for (Vector& corner : corners) corner += shift;
    corners.push_back(corners.front());
    lines.line(corners, colour);
}

void add_bodies(const Scene& scene, Parts& parts) {
    for (const SceneBody& body : scene.bodies) {
        if (body.outline.empty()) {
            add_glyph(body, parts);
            continue;
        }
        parts.clear.prism(body.outline, body.normal, body.thickness, parts.colour(Role::body), plate_opacity);
        for (double side : {-0.5, 0.5})
            add_outline(body.outline, side * body.thickness * body.normal, parts.lines,
                        parts.colour(Role::link));
    }
}

void add_links(const Scene& scene, Parts& parts) {
    for (const SceneLink& link : scene.links) {
        const bool seeing = link.kind == LinkKind::sight_line || link.kind == LinkKind::field_of_view;
        const Colour colour = parts.colour(seeing ? Role::sight_line : Role::link);
        if (link.radius > 0) {
            parts.solids.cylinder(link.from, link.to, link.radius, colour);
            if (link.kind == LinkKind::robot_link)  // round joints
                for (const Vector& end : {link.from, link.to})
                    parts.solids.sphere(end, 1.35 * link.radius, colour);
        } else if (link.dash > 0) {
            parts.lines.dashes(link.from, link.to, link.dash, colour);
        } else {
            parts.lines.line({link.from, link.to}, colour);
        }
    }
}

void add_ellipsoids(const std::vector<SceneEllipsoid>& ellipsoids, double opacity, Parts& parts) {
    for (const SceneEllipsoid& ellipsoid : ellipsoids) {
        const Colour colour = parts.colour(ellipsoid.role);
        Eigen::Matrix3d axes = ellipsoid.axes;
        // A flat region has no third axis: give it a thin body so that it is seen from every side.
        const double thin = 0.01 * axes.col(0).norm();
        if (ellipsoid.rank < 2) axes.col(1) = thin * axes.col(0).unitOrthogonal();
        if (ellipsoid.rank < 3) axes.col(2) = thin * axes.col(0).cross(axes.col(1)).normalized();
        parts.clear.ellipsoid(ellipsoid.item.position, axes, colour, opacity);
        for (int plane = 0; plane < 3; ++plane) {  // principal sections
            std::vector<Vector> ring;
            for (int i = 0; i <= 72; ++i) {
                const double t = i * 2 * 3.14159265358979323846 / 72;
                ring.push_back(ellipsoid.item.position + std::cos(t) * axes.col(plane) +
                               std::sin(t) * axes.col((plane + 1) % 3));
            }
            parts.lines.line(ring, colour, 0.55);
        }
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
            add_points(scene, parts);
            break;
        case Layer::bodies:
            add_bodies(scene, parts);
            break;
        case Layer::links:
            add_links(scene, parts);
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
    return parts.actors(layer == Layer::links ? 1.4 : edge_width);
}

}  // namespace covaria::detail
