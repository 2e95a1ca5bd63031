#include "viz/scene/asset_scene.h"

namespace covaria {

std::optional<Scene> asset_scene(const Asset& asset, const SceneOptions& options) {
    const Layout layout = asset.layout();
    if (layout.bodies.empty() && layout.links.empty()) return std::nullopt;
    SceneSource source;
    source.layout = &layout;
    return build_scene(source, options);
}

}  // namespace covaria
