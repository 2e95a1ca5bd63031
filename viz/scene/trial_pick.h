// The trial of Monte Carlo whose dot in a cloud is under the pointer.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "viz/scene/camera.h"
#include "viz/scene/scene.h"

namespace covaria {

/// The trial of the nearest dot within `reach` pixels, of all clouds shown; among dots at equal distance the
/// foremost counts. The trial's number is that of `replay_trials`.
std::optional<std::uint64_t> trial_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                                      const std::function<bool(Layer)>& shown, double reach);

}  // namespace covaria
