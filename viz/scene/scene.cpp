// Scene: identity of items, look-up, bounds.
#include "viz/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace covaria {
namespace {

/// Grows with each point; starts empty.
class Box {
public:
    void add(const Eigen::Vector3d& p, double margin = 0.0) {
        low_ = low_.cwiseMin(p - Eigen::Vector3d::Constant(margin));
        high_ = high_.cwiseMax(p + Eigen::Vector3d::Constant(margin));
    }
    bool is_empty() const { return (low_.array() > high_.array()).any(); }
    SceneBounds bounds() const {
        if (is_empty()) return {};
        return {low_, high_};
    }

private:
    static constexpr double far_ = std::numeric_limits<double>::infinity();
    Eigen::Vector3d low_ = Eigen::Vector3d::Constant(far_);
    Eigen::Vector3d high_ = Eigen::Vector3d::Constant(-far_);
};

void add_uncertainties(const Scene& scene, Box& box) {
    for (const auto* ellipsoids : {&scene.ellipsoids, &scene.ellipsoids_before})
        for (const SceneEllipsoid& ellipsoid : *ellipsoids) {
            const Eigen::Vector3d half = ellipsoid.axes.rowwise().norm();
            box.add(ellipsoid.item.position + half);
            box.add(ellipsoid.item.position - half);
        }
    for (const SceneCloud& cloud : scene.clouds)
        for (std::size_t i = 0; i + 2 < cloud.offsets.size(); i += 3)
            box.add(cloud.item.position +
                    Eigen::Vector3d(cloud.offsets[i], cloud.offsets[i + 1], cloud.offsets[i + 2]));
}

void add_items(const Scene& scene, Box& box) {
    for (const SceneFrame& frame : scene.frames) box.add(frame.item.position);
    for (const ScenePoint& point : scene.points) box.add(point.item.position, point.radius);
    for (const SceneBody& body : scene.bodies) {
        for (const Eigen::Vector3d& corner : body.outline) box.add(corner, body.thickness / 2);
        if (!body.outline.empty()) continue;
        box.add(body.item.position, body.size / 2);
        const Eigen::Vector3d& p = body.item.position;
        if (scene.floor) box.add({p.x(), p.y(), *scene.floor});
    }
    for (const SceneLink& link : scene.links) {
        box.add(link.from, link.radius);
        box.add(link.to, link.radius);
    }
    for (const SceneVector& vector : scene.vectors) {
        box.add(vector.item.position);
        box.add(vector.item.position + vector.arrow);
    }
    add_uncertainties(scene, box);
    if (scene.map)
        for (std::size_t i = 0; i < scene.map->positions.size(); ++i)
            if (std::isfinite(scene.map->values[i])) box.add(scene.map->positions[i], scene.map->radius);
}

void add_axes(const Scene& scene, Box& box) {
    if (!scene.axes) return;
    box.add(scene.axes->low);
    box.add(scene.axes->high);
}

void add_meshes(const Scene& scene, Box& box) {
    for (const SceneMesh& mesh : scene.meshes)
        for (int i = 0; i < 8; ++i) {
            const auto corner = static_cast<Eigen::AlignedBox3f::CornerType>(i);
            box.add(mesh.in_W(mesh.triangles->box.corner(corner).cast<double>()));
        }
}

template <class Items>
const SceneItem* find_in(const Items& items, const std::string& id) {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const auto& i) { return i.item.id == id; });
    return found == items.end() ? nullptr : &found->item;
}

}  // namespace

const char* layer_key(Layer layer) {
    static constexpr const char* keys[layer_count] = {
        "frames",          "points", "bodies", "links",  "vectors", "ellipsoids",        "clouds",
        "wall_histograms", "labels", "axes",   "legend", "map",     "ellipsoids_before", "meshes"};
    return keys[static_cast<std::size_t>(layer)];
}

bool SceneMap::operator==(const SceneMap& other) const {
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    return title == other.title && positions == other.positions && shown == other.shown &&
           radius == other.radius && low == other.low && high == other.high && ticks == other.ticks &&
           grid == other.grid && levels == other.levels && marked == other.marked && ways == other.ways &&
           way_radius == other.way_radius &&
           std::equal(values.begin(), values.end(), other.values.begin(), other.values.end(), same);
}

std::string name_of(const SceneItem& item) {
    return item.name.empty() ? item.id.substr(item.id.find(':') + 1) : std::string(item.name);
}

bool stand_by_one_field(const SceneItem& a, const SceneItem& b) {
    return a.source.path == b.source.path && a.source.asset == b.source.asset;
}

bool SceneItem::operator==(const SceneItem& other) const {
    return id == other.id && body == other.body && name == other.name && group == other.group &&
           position == other.position && u == other.u && U == other.U && stated == other.stated &&
           source.path == other.source.path && source.asset == other.source.asset &&
           source.draggable == other.source.draggable && source.X_WS.matrix() == other.source.X_WS.matrix();
}

bool SceneMesh::operator==(const SceneMesh& other) const {
    return item == other.item && triangles == other.triangles && scale == other.scale &&
           X_WM.matrix() == other.X_WM.matrix() && colour == other.colour && opacity == other.opacity;
}

bool draws_uncertainty(const Scene& scene) {
    return !scene.ellipsoids.empty() || !scene.ellipsoids_before.empty() || !scene.clouds.empty();
}

const SceneItem* find_item(const Scene& scene, const std::string& id) {
    if (const SceneItem* item = find_in(scene.points, id)) return item;
    if (const SceneItem* item = find_in(scene.frames, id)) return item;
    if (const SceneItem* item = find_in(scene.bodies, id)) return item;
    if (const SceneItem* item = find_in(scene.links, id)) return item;
    if (const SceneItem* item = find_in(scene.vectors, id)) return item;
    return find_in(scene.meshes, id);
}

SceneBounds bounds_of(const Scene& scene) {
    Box box;
    add_items(scene, box);
    add_axes(scene, box);
    if (box.is_empty()) add_meshes(scene, box);
    return box.bounds();
}

SceneBounds bounds_of_items(const Scene& scene) {
    Box box;
    add_items(scene, box);
    if (box.is_empty()) add_meshes(scene, box);
    return box.bounds();
}

SceneBounds bounds_with_meshes(const Scene& scene) {
    Box box;
    add_items(scene, box);
    add_axes(scene, box);
    add_meshes(scene, box);
    return box.bounds();
}

}  // namespace covaria
