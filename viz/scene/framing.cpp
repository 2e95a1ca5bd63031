#include "viz/scene/framing.h"

#include <algorithm>
#include <map>
#include <utility>

namespace covaria {
namespace {

/// By the ids of its items: whether each is in the picture.
std::map<std::string, bool> items_in_picture(const Scene& scene, const Camera& camera, PictureSize size) {
    std::map<std::string, bool> seen;
    const auto add = [&](const auto& items) {
        for (const auto& each : items) {
            const Pixel at = project(camera, size, each.item.position);
            seen[each.item.id] = at.x >= 0 && at.y >= 0 && at.x <= size.width && at.y <= size.height;
        }
    };
    add(scene.points);
    add(scene.frames);
    add(scene.bodies);
    add(scene.vectors);
    return seen;
}

/// Out of the picture now, and not for a turn of the camera.
bool has_left(const std::pair<const std::string, bool>& item, const std::map<std::string, bool>& before) {
    const auto found = before.find(item.first);
    return !item.second && (found == before.end() || found->second);
}

}  // namespace

Framing::Judgement Framing::next(std::shared_ptr<const Scene> scene, bool framed, bool held) {
    const bool other = !before_ || before_->title != scene->title;
    if (other) explained_ = 0;
    const bool explains_more = scene->legend.size() > explained_;
    explained_ = std::max(explained_, scene->legend.size());
    if (held) return [](const Camera&, PictureSize) { return false; };
    const auto before = std::exchange(before_, scene);
    if (framed && (other || explains_more)) return [](const Camera&, PictureSize) { return true; };
    return [=](const Camera& camera, PictureSize size) {
        const auto now = items_in_picture(*scene, camera, size);
        const auto earlier = before ? items_in_picture(*before, camera, size) : std::map<std::string, bool>{};
        if (framed)
            return std::ranges::any_of(now, [&](const auto& item) { return has_left(item, earlier); });
        const auto is_seen = [](const auto& item) { return item.second; };
        return !now.empty() && std::ranges::none_of(now, is_seen) &&
               (other || std::ranges::any_of(earlier, is_seen));
    };
}

}  // namespace covaria
