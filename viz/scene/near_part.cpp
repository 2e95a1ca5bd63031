#include "viz/scene/near_part.h"

#include <algorithm>

namespace covaria::detail {
namespace {

constexpr double farthest = 1e15;  // m; a tenth of a light year

bool are_near(const std::vector<Eigen::Vector3d>& places) {
    return std::ranges::all_of(places, is_near);
}

bool stands_near(const LayoutFrame& frame) {
    return is_near(frame.X_WF.translation());
}

bool stands_near(const LayoutPoint& point) {
    return is_near(point.p_W);
}

bool stands_near(const LayoutLink& link) {
    return is_near(link.from_W) && is_near(link.to_W);
}

bool stands_near(const LayoutBody& body) {
    return is_near(body.X_WB.translation()) && are_near(body.outline_W);
}

bool stands_near(const LayoutVector& vector) {
    return is_near(vector.at_W) && vector.vector_W.allFinite();
}

bool stands_near(const LayoutMesh& mesh) {
    const Eigen::Vector3d low = mesh.scale * mesh.triangles->box.min().cast<double>(),
                          high = mesh.scale * mesh.triangles->box.max().cast<double>();
    return mesh.triangles->box.isEmpty() || (is_near(mesh.X_WM * low) && is_near(mesh.X_WM * high));
}

template <class Item>
void keep_near(std::vector<Item>& items, std::vector<std::string>& left_out) {
    std::erase_if(items, [&left_out](const Item& item) {
        if (stands_near(item)) return false;
        const bool is_named = !item.name.empty() && std::ranges::find(left_out, item.name) == left_out.end();
        if (is_named || left_out.empty()) left_out.push_back(item.name);
        return true;
    });
}

}  // namespace

bool is_near(const Eigen::Vector3d& place) {
    return (place.array().abs() <= farthest).all();
}

std::optional<NearPart> near_part(const Layout& layout) {
    const auto all_near = [](const auto& items) {
        return std::ranges::all_of(items, [](const auto& item) { return stands_near(item); });
    };
    if (all_near(layout.points) && all_near(layout.frames) && all_near(layout.bodies) &&
        all_near(layout.links) && all_near(layout.vectors) && all_near(layout.meshes))
        return std::nullopt;
    NearPart part{layout, {}};
    keep_near(part.layout.points, part.left_out);
    keep_near(part.layout.frames, part.left_out);
    keep_near(part.layout.bodies, part.left_out);
    keep_near(part.layout.links, part.left_out);
    keep_near(part.layout.vectors, part.left_out);
    keep_near(part.layout.meshes, part.left_out);
    return part;
}

Message words_of_left_out(const std::vector<std::string>& left_out) {
    return tell<"not drawn, for it is farther away than 10¹² km: %1">(
        left_out.size() > 1 ? left_out.front() + ", …" : left_out.front());
}

}  // namespace covaria::detail
