// Decides when a picture is framed anew: a user's view stays while the scene in it is edited.
#pragma once

#include <functional>
#include <memory>

#include "viz/scene/camera.h"
#include "viz/scene/label_placement.h"

namespace covaria {

/// Remembers the scene before, and compares: it was one of the same thing, or of another.
class Framing {
public:
    /// Asked with the camera that looks at the scene when it comes.
    using Judgement = std::function<bool(const Camera&, PictureSize)>;

    /// Tells whether to frame the next scene. `framed`: nobody has chosen what is in the picture. `held`:
    /// something is being dragged, and nothing moves but that; what has left the picture by then is seen when
    /// the first scene comes that is not held.
    Judgement next(std::shared_ptr<const Scene> scene, bool framed, bool held);

private:
    std::shared_ptr<const Scene> before_;
    std::size_t explained_ = 0;  ///< most lines of the legend, which a framed scene stands beside
};

/// The same direction; what is drawn of a scene fills `inside` of the picture as far as it can. Orthographic.
Camera filling(const Camera& camera, const Scene& scene, PictureSize size, const ScreenRect& inside);
/// The same for a box.
Camera filling(const Camera& camera, const SceneBounds& bounds, PictureSize size, const ScreenRect& inside);

}  // namespace covaria
