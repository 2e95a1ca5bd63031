// The hidden part of a scene, and one thing shown alone.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "viz/scene/scene.h"

namespace covaria {

struct Visibility {
    std::set<std::string> hidden = {};  ///< ids of items
    std::string only = {};              ///< id of the item that is shown alone; empty: all but `hidden`
    bool shows_all() const { return hidden.empty() && only.empty(); }
    bool operator==(const Visibility&) const = default;
};

/// Id of the thing that hiding an item concerns: the axes and the place of an instrument stand for its body.
std::string thing_of(const Scene& scene, const std::string& item);

/// The scene without what is hidden, its label, ellipsoid and cloud. With a body go its axes, its place and
/// the lines that start from it, with a point the lines of sight to it; other points stay. Alone is an item
/// with what stands on it, in axes of its own. An id that the scene does not have hides nothing, and is not
/// shown alone.
Scene visible_part(Scene scene, const Visibility& visibility);

/// Ids of what stands in the set-up of an asset.
std::set<std::string> items_of_asset(const Scene& scene, const std::string& asset);
/// Whether any of them is in the shown part of a scene; empty: the asset has nothing in the scene.
std::optional<bool> shows_asset(const Scene& scene, const Scene& shown, const std::string& asset);
/// The same with all of them shown, or hidden.
Visibility with_asset(Visibility visibility, const Scene& scene, const std::string& asset, bool shown);

}  // namespace covaria
