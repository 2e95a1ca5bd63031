// The scene of an asset by itself: its body, for the library's pictures and for a project without analyses.
#pragma once

#include <optional>

#include "core/model/asset.h"
#include "viz/scene/build_scene.h"

namespace covaria {

/// Nullopt: the asset has no body to draw.
std::optional<Scene> asset_scene(const Asset& asset, const SceneOptions& options);

}  // namespace covaria
