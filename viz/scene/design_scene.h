// The scene of a design: the state that was found, the candidates where they stand, coloured by what they
// gain, and the way of the search.
#pragma once

#include "core/result/design_result.h"
#include "viz/scene/build_scene.h"

namespace covaria {

/// Pure data; of `options` the group is used. A design of which nothing stands in space, and one that was not
/// found, has a caption that says so.
Scene design_scene(const DesignResult& design, const SceneOptions& options);

}  // namespace covaria
