#include "viz/scene/visibility.h"

#include <algorithm>
#include <vector>

#include "viz/scene/build_parts.h"

namespace covaria {
namespace {

class Filter {
public:
    Filter(const Scene& scene, const Visibility& visibility) : visibility_(visibility) {
        if (!visibility.only.empty() && find_item(scene, visibility.only)) only_ = visibility.only;
    }
    bool isolates() const { return !only_.empty(); }
    /// `goes_along`: it goes where its body goes.
    bool shows(const SceneItem& item, bool goes_along) const {
        if (is_hidden(item.id) || (goes_along && is_hidden(item.body))) return false;
        return only_.empty() || item.id == only_ || item.body == only_;
    }

private:
    bool is_hidden(const std::string& id) const { return !id.empty() && visibility_.hidden.contains(id); }
    const Visibility& visibility_;
    std::string only_;
};

/// Whether the line explains something that is drawn.
bool explains(const LegendLine& line, const Scene& scene) {
    const auto is_role = [&](const auto& item) { return item.role == line.role; };
    switch (line.mark) {
        case LegendMark::ellipsoid:
            return std::ranges::any_of(scene.ellipsoids, is_role) ||
                   std::ranges::any_of(scene.ellipsoids_before, is_role);
        case LegendMark::cloud:
            return std::any_of(scene.clouds.begin(), scene.clouds.end(), is_role);
        case LegendMark::histogram:
            return !scene.wall_histograms.empty();
        case LegendMark::line:
            return std::any_of(scene.links.begin(), scene.links.end(), [&](const SceneLink& link) {
                return line.role == Role::not_met ? link.is_doubtful : link.kind == LinkKind::sight_line;
            });
        case LegendMark::arrow:
            return !scene.vectors.empty();
        case LegendMark::diamond:
            return !scene.not_met.empty();
        case LegendMark::none:  // a line on uncertainty that is too small to see, or on the whole
            return line.role == Role::quiet_text || std::ranges::any_of(scene.ellipsoids, is_role) ||
                   std::ranges::any_of(scene.ellipsoids_before, is_role) ||
                   std::ranges::any_of(scene.clouds, is_role);
    }
    return true;
}

/// Whether the item is the place of that body.
bool is_its_body(const SceneItem& item, const SceneItem* body) {
    return body && !body->source.path.empty() && stand_by_one_field(item, *body);
}

std::vector<Eigen::Vector3d> places_of_hidden(const Scene& scene, const Visibility& visibility) {
    std::vector<Eigen::Vector3d> places;
    for (const ScenePoint& point : scene.points)
        if (visibility.hidden.contains(point.item.id)) places.push_back(point.item.position);
    return places;
}

/// Erases lines of sight that would end at nothing.
void erase_sight_of_hidden(Scene& scene, const std::vector<Eigen::Vector3d>& places) {
    constexpr double same = 1e-9;  // m
    std::erase_if(scene.links, [&](const SceneLink& link) {
        return link.kind == LinkKind::sight_line && std::ranges::any_of(places, [&](const auto& place) {
                   return (link.from - place).norm() < same || (link.to - place).norm() < same;
               });
    });
}

}  // namespace

std::string thing_of(const Scene& scene, const std::string& item) {
    const SceneItem* found = find_item(scene, item);
    return found && is_its_body(*found, find_item(scene, found->body)) ? found->body : item;
}

Scene visible_part(Scene scene, const Visibility& visibility) {
    if (visibility.shows_all()) return scene;
    const Filter filter(scene, visibility);
    const std::vector<Eigen::Vector3d> hidden = places_of_hidden(scene, visibility);
    std::set<std::string> shown, places;  // ids of the items that remain, and of the places of bodies
    for (const ScenePoint& point : scene.points)
        if (is_its_body(point.item, find_item(scene, point.item.body))) places.insert(point.item.id);
    const auto keep = [&](auto& items, bool goes_along) {
        std::erase_if(items, [&](const auto& each) {
            return !filter.shows(each.item, goes_along || places.contains(each.item.id));
        });
        for (const auto& each : items) shown.insert(each.item.id);
    };
    keep(scene.frames, true);
    keep(scene.points, false);
    keep(scene.bodies, true);
    keep(scene.links, true);
    keep(scene.vectors, true);
    keep(scene.meshes, false);
    erase_sight_of_hidden(scene, hidden);
    const auto is_gone = [&](const auto& each) { return !shown.contains(each.item.id); };
    std::erase_if(scene.ellipsoids, is_gone);
    std::erase_if(scene.ellipsoids_before, is_gone);
    std::erase_if(scene.clouds, is_gone);
    std::erase_if(scene.wall_histograms,
                  [&](const SceneWallHistogram& wall) { return !shown.contains(wall.cloud); });
    std::erase_if(scene.labels, [&](const SceneLabel& label) {
        return !label.item.empty() && !shown.contains(label.item);
    });
    std::erase_if(scene.not_met, [&](const SceneVerdict& mark) { return !shown.contains(mark.item); });
    std::erase_if(scene.legend, [&](const LegendLine& line) { return !explains(line, scene); });
    if (filter.isolates()) detail::add_axes(scene);
    return scene;
}

std::set<std::string> items_of_asset(const Scene& scene, const std::string& asset) {
    std::set<std::string> ids;
    const auto add = [&](const auto& items) {
        for (const auto& each : items)
            if (each.item.source.asset == asset) ids.insert(each.item.id);
    };
    add(scene.frames);
    add(scene.points);
    add(scene.bodies);
    add(scene.vectors);
    add(scene.meshes);
    return ids;
}

std::optional<bool> shows_asset(const Scene& scene, const Scene& shown, const std::string& asset) {
    const std::set<std::string> items = items_of_asset(scene, asset);
    if (items.empty()) return {};
    return std::ranges::any_of(items, [&](const std::string& id) { return find_item(shown, id) != nullptr; });
}

Visibility with_asset(Visibility visibility, const Scene& scene, const std::string& asset, bool shown) {
    for (const std::string& id : items_of_asset(scene, asset)) {
        if (!shown)
            visibility.hidden.insert(id);
        else
            visibility.hidden.erase(id);
    }
    if (shown) visibility.only.clear();
    return visibility;
}

}  // namespace covaria
