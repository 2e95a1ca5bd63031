// Turns a camera with what is hidden into a view saved in the project, and back.
#pragma once

#include "core/project/saved_view.h"
#include "viz/scene/camera.h"
#include "viz/scene/visibility.h"

namespace covaria {

SavedView saved_view(const std::string& name, const Camera& camera, PictureSize size,
                     const Visibility& visibility);
/// The camera of a saved view: all that it shows is in a picture of any form.
Camera camera_of(const SavedView& view, PictureSize size);
Visibility visibility_of(const SavedView& view);

}  // namespace covaria
