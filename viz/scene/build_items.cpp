// Frames, points, bodies, links and vectors of a scene, sized to the whole.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/text/numbers.h"
#include "viz/scene/arms.h"
#include "viz/scene/build_parts.h"
#include "viz/scene/solids.h"

namespace covaria::detail {
namespace {

// Fractions of the diagonal of the layout.
constexpr double frame_length = 0.11;
constexpr double point_radius = 0.011, least_point_radius = 0.0045;
constexpr double reflector_radius = 0.019;  // m: a ball is no larger than it is, where it is seen so
constexpr double plate_thickness = 0.012;
constexpr double seat_height = 0.75;  // part of the radius of its ball
constexpr double plate_margin = 0.032;
// An instrument is as large as it is, as far as it can be made out and does not hide what it measures.
constexpr double instrument_size = 0.36;  // m
constexpr double least_instrument = 0.05, largest_instrument = 0.12;
constexpr double foot_height = 0.035;
constexpr std::size_t corners_of_path = 24;  // an outline of so many corners was traced, not made
constexpr double longest_vector = 0.6;
constexpr double one_place = 1e-15;    // m: what is no farther apart is
constexpr double smallest_size = 0.1;  // m, when everything is in one place

double diagonal_of(const SceneBuild& build) {
    Eigen::AlignedBox3d box;
    const Layout& layout = *build.source.layout;
    for (const LayoutFrame& frame : layout.frames)
        if (build.shows(frame.group)) box.extend(frame.X_WF.translation());
    for (const LayoutPoint& point : layout.points)
        if (build.shows(point.group)) box.extend(point.p_W);
    for (const LayoutLink& link : layout.links)
        if (build.shows(link.group)) box.extend(link.from_W).extend(link.to_W);
    for (const LayoutBody& body : layout.bodies) {
        if (!build.shows(body.group)) continue;
        if (body.outline_W.empty()) box.extend(body.X_WB.translation());
        for (const Eigen::Vector3d& corner : body.outline_W) box.extend(corner);
    }
    for (const LayoutVector& vector : layout.vectors)
        if (build.shows(vector.group)) box.extend(vector.at_W);
    if (box.isEmpty())
        for (const LayoutMesh& mesh : layout.meshes)
            for (int i = 0; i < 8; ++i) {
                const auto corner = static_cast<Eigen::AlignedBox3f::CornerType>(i);
                box.extend(mesh.X_WM * (mesh.scale * mesh.triangles->box.corner(corner).cast<double>()));
            }
    if (box.isEmpty()) return 0.0;
    const double diagonal = box.diagonal().norm();
    return std::isfinite(diagonal) && diagonal > one_place ? diagonal : smallest_size;
}

void add_frames(SceneBuild& build) {
    for (const LayoutFrame& frame : build.source.layout->frames) {
        if (!build.shows(frame.group)) continue;
        SceneFrame& added = build.scene.frames.emplace_back();
        added.item = {.id = build.unique_id("frame", frame.name),
                      .name = frame.name,
                      .group = frame.group,
                      .position = frame.X_WF.translation(),
                      .source = frame.source};
        added.R_WF = frame.X_WF.linear();
        added.length = frame_length * build.scene.size;
    }
}

/// Normal of the plate whose outline the point belongs to.
Eigen::Vector3d seat_axis(const SceneBuild& build, const Eigen::Vector3d& p_W) {
    const double near = 1e-6 * build.scene.size;
    for (const LayoutBody& body : build.source.layout->bodies) {
        if (!build.shows(body.group)) continue;
        for (const Eigen::Vector3d& corner : body.outline_W)
            if ((corner - p_W).norm() <= near) return normal_of(body.outline_W);
    }
    return Eigen::Vector3d::UnitZ();
}

/// Radius of the balls of a scene.
double ball_radius_in(const Scene& scene) {
    return std::clamp(reflector_radius, least_point_radius * scene.size, point_radius * scene.size);
}

/// Radius of points of a kind, relative to that of the usual ones.
double radius_of(PointKind kind) {
    switch (kind) {
        case PointKind::ball:
            return 1.5;
        case PointKind::station:
            return 1.3;
        case PointKind::other:
            return 0.7;
        default:
            return 1.0;
    }
}

/// Many points are drawn smaller.
double crowd_factor(std::size_t points) {
    return std::min(1.0, 8.0 / std::sqrt(static_cast<double>(std::max<std::size_t>(points, 1))));
}

std::optional<Eigen::Vector3d> stated_coordinates(const SceneBuild& build, const LayoutPoint& point) {
    if (!point.outputs) return std::nullopt;
    Eigen::Vector3d stated;
    for (std::size_t i = 0; i < 3; ++i)
        stated[static_cast<Eigen::Index>(i)] = build.source.result->outputs[(*point.outputs)[i]].estimate;
    return stated;
}

void add_points(SceneBuild& build) {
    const double scale = crowd_factor(build.source.layout->points.size()) * ball_radius_in(build.scene);
    for (const LayoutPoint& point : build.source.layout->points) {
        if (!build.shows(point.group)) continue;
        ScenePoint& added = build.scene.points.emplace_back();
        added.item = {.id = build.unique_id("point", point.name),
                      .name = point.name,
                      .group = point.group,
                      .position = point.p_W,
                      .source = point.source};
        if (const auto uncertainty = build.uncertainties.of(point)) {
            added.item.u = uncertainty->u;
            added.item.U = uncertainty->U;
            if (!build.source.layout->notes.empty()) added.item.stated = stated_coordinates(build, point);
        }
        added.kind = point.kind;
        added.radius = radius_of(point.kind) * scale;
        added.axis = seat_axis(build, point.p_W);
        added.coordinates = coordinates_of(point);
    }
}

double instrument_size_in(const Scene& scene) {
    return std::clamp(instrument_size, least_instrument * scene.size, largest_instrument * scene.size);
}

/// The axes in which an instrument reads; its name is on the glyph already.
void add_instrument_axes(SceneBuild& build, const LayoutBody& body) {
    SceneFrame& added = build.scene.frames.emplace_back();
    added.item.id = build.unique_id("axes", body.name);
    added.item.group = body.group;
    added.item.position = body.X_WB.translation();
    added.item.source = body.source;
    added.R_WF = body.X_WB.linear();
    added.length = instrument_size_in(build.scene);
}

void add_bodies(SceneBuild& build) {
    for (const LayoutBody& body : build.source.layout->bodies) {
        if (!build.shows(body.group)) continue;
        SceneBody added;
        added.item = {.id = build.unique_id("body", body.name),
                      .name = body.name,
                      .group = body.group,
                      .position = body.X_WB.translation(),
                      .source = body.source};
        added.kind = body.kind;
        added.glyph = body.glyph;
        added.R_WB = body.X_WB.linear();
        added.size = instrument_size_in(build.scene);
        added.thickness = body.thickness > 0 ? body.thickness : plate_thickness * build.scene.size;
        if (body.outline_W.size() >= 3) {
            added.normal = normal_of(body.outline_W);
            added.corners = body.outline_W.size();
            added.encloses = added.corners >= corners_of_path;
            added.outline = rounded_outline(body.outline_W, added.normal, plate_margin * build.scene.size);
            // The points sit on the plate: their centres, and frames between them, stay above it.
            const double down = added.thickness / 2 + seat_height * ball_radius_in(build.scene);
            for (Eigen::Vector3d& corner : added.outline) corner -= down * added.normal;
            added.item.position.setZero();
            for (const Eigen::Vector3d& corner : body.outline_W)
                added.item.position += corner / static_cast<double>(body.outline_W.size());
        }
        build.scene.bodies.push_back(std::move(added));
        if (body.kind == BodyKind::instrument) add_instrument_axes(build, body);
    }
}

double link_radius(LinkKind kind) {
    switch (kind) {
        case LinkKind::leg:
            return 0.011;
        case LinkKind::robot_link:  // a tool: a link of an arm without joints
            return 0.012;
        case LinkKind::bar:
            return 0.006;
        default:
            return 0.0;
    }
}

void add_links(SceneBuild& build) {
    for (const LayoutLink& link : build.source.layout->links) {
        if (!build.shows(link.group)) continue;
        SceneLink& added = build.scene.links.emplace_back();
        added.item = {.id = build.unique_id("link", link.name),
                      .name = link.name,
                      .group = link.group,
                      .position = (link.from_W + link.to_W) / 2};
        added.kind = link.kind;
        added.from = link.from_W;
        added.to = link.to_W;
        added.radius = link_radius(link.kind) * build.scene.size;
        added.is_doubtful = link.is_doubtful;
        added.is_dashed = link.kind == LinkKind::sight_line || link.kind == LinkKind::joint_axis;
    }
    shape_arms(build.scene);
}

/// The tip is a point whose coordinates are the vector's, to its scale.
void add_tip(SceneBuild& build, const LayoutVector& vector, const SceneVector& drawn, double scale) {
    if (!vector.outputs) return;
    VectorTip& tip = build.tips.emplace_back();
    tip.item = drawn.item;
    tip.item.position += drawn.arrow;
    tip.point.group = vector.group;
    tip.point.p_W = tip.item.position;
    tip.point.outputs = vector.outputs;
    tip.point.R_WQ = scale * vector.R_WQ;
}

/// Drawn length per unit of the vectors of a kind, m: the longest has the same length for every kind.
double vector_scale(const SceneBuild& build, VectorKind kind) {
    double longest = 0.0;
    for (const LayoutVector& vector : build.source.layout->vectors)
        if (vector.kind == kind && build.shows(vector.group))
            longest = std::max(longest, vector.vector_W.norm());
    return longest > 0.0 && std::isfinite(longest) ? longest_vector * build.scene.size / longest : 0.0;
}

/// "F 79.93 N"
std::string label_of(const LayoutVector& vector, const NumberLocale& numbers) {
    if (!vector.is_measured) return vector.name;
    return vector.name + " " + typeset_number(format_short(vector.vector_W.norm(), 4), numbers) +
           (vector.kind == VectorKind::moment ? " N·m" : " N");
}

void add_vectors(SceneBuild& build) {
    for (const LayoutVector& vector : build.source.layout->vectors) {
        const double scale = vector_scale(build, vector.kind);
        if (!build.shows(vector.group) || !(scale > 0.0)) continue;
        SceneVector& added = build.scene.vectors.emplace_back();
        added.item = {.id = build.unique_id("vector", vector.name),
                      .name = vector.name,
                      .group = vector.group,
                      .position = vector.at_W};
        added.label = label_of(vector, build.scene.numbers);
        added.kind = vector.kind;
        added.arrow = vector.vector_W * scale;
        added.radius = 0.006 * build.scene.size;
        add_tip(build, vector, added, scale);
    }
}

void add_meshes(SceneBuild& build, const std::vector<LayoutMesh>& meshes) {
    for (const LayoutMesh& mesh : meshes) {
        SceneMesh& added = build.scene.meshes.emplace_back();
        added.triangles = mesh.triangles;
        added.scale = mesh.scale;
        added.X_WM = mesh.X_WM;
        added.colour = mesh.colour;
        added.opacity = mesh.opacity;
        added.item.id = build.unique_id("mesh", mesh.name);
        added.item.name = mesh.name;
        added.item.position = added.in_W(mesh.triangles->box.center().cast<double>());
        added.item.source = mesh.source;
    }
}

/// Attaches points on the outline of a body, axes at its place, and lines that start from it and no other.
void attach_to_bodies(SceneBuild& build) {
    Scene& scene = build.scene;
    const double near = 1e-6 * scene.size;
    std::size_t next = 0;
    for (const LayoutBody& body : build.source.layout->bodies) {
        if (!build.shows(body.group) || next >= scene.bodies.size()) continue;
        const std::string& id = scene.bodies[next++].item.id;
        std::vector<Eigen::Vector3d> places = body.outline_W;
        if (places.empty()) places = {body.X_WB.translation()};
        const auto is_at = [&](const Eigen::Vector3d& p) {
            return std::any_of(places.begin(), places.end(),
                               [&](const Eigen::Vector3d& place) { return (place - p).norm() <= near; });
        };
        const auto attach = [&](SceneItem& item) {
            if (item.body.empty()) item.body = id;
        };
        for (ScenePoint& point : scene.points)
            if (is_at(point.item.position)) attach(point.item);
        for (SceneFrame& frame : scene.frames)
            if (is_at(frame.item.position)) attach(frame.item);
        for (SceneLink& link : scene.links)
            if (is_at(link.from)) attach(link.item);
    }
}

/// Instruments look at the middle of their targets.
void turn_to_targets(Scene& scene) {
    std::map<std::string, Eigen::Vector3d> sights;
    for (const SceneLink& link : scene.links)
        if (link.kind == LinkKind::sight_line && (link.to - link.from).norm() > 0)
            sights.try_emplace(link.item.body, Eigen::Vector3d::Zero()).first->second +=
                (link.to - link.from).normalized();
    for (SceneBody& body : scene.bodies)
        if (const auto found = sights.find(body.item.id); found != sights.end() && found->second.norm() > 0)
            body.sight = found->second.normalized();
}

}  // namespace

void add_items(SceneBuild& build) {
    build.scene.size = diagonal_of(build);
    if (!(build.scene.size > 0)) return;
    add_frames(build);
    add_points(build);
    if (build.options.bodies) add_bodies(build);
    if (build.options.links) add_links(build);
    add_vectors(build);
    add_meshes(build, build.source.layout->meshes);
    add_meshes(build, build.options.context);
    attach_to_bodies(build);
    turn_to_targets(build.scene);
}

void add_floor(Scene& scene) {
    if (scene.bodies.empty() && scene.points.empty() && scene.links.empty()) return;
    constexpr double upright = 0.95, at_bottom = 0.02;  // the second as a part of the scene's size
    const double bottom = lowest_of(scene);
    for (SceneBody& body : scene.bodies)
        if (!body.outline.empty() && !body.encloses && body.normal.z() > upright &&
            std::ranges::all_of(body.outline, [&](const Eigen::Vector3d& corner) {
                return corner.z() - body.thickness < bottom + at_bottom * scene.size;
            }))
            body.feet = foot_height * scene.size;
    scene.floor = lowest_of(scene);
    const bool rests =
        std::ranges::any_of(scene.bodies, [](const SceneBody& body) { return body.feet > 0; }) ||
        std::ranges::any_of(scene.links, [](const SceneLink& link) { return link.stands; });
    const double lowest = lowest_uncertainty_of(scene);
    if (!rests && std::isfinite(lowest)) scene.floor = std::min(*scene.floor, lowest);
}

}  // namespace covaria::detail
