// A scene as a file for other programs: glTF for viewers, VTP for ParaView. No VTK in this header.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "viz/scene/scene.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria {

enum class SceneFormat {
    /// Shapes with their colours, in metres, with y up as the format has it: (x, y, z) of W is (x, z, −y).
    gltf,
    /// The same shapes in metres and axes of W as one mesh, of each vertex its colour and layer; and a vertex
    /// for each point with its standard uncertainties along x, y, z ("u", m; not a number where unknown).
    vtp,
};

/// Format by the ending of a file's name: ".gltf", ".vtp", in any letter case; a picture's ending has none.
std::optional<SceneFormat> scene_format_of(const std::string& ending);

/// Everything that is shown of the scene but words, axes and histograms on walls; uncertainties magnified as
/// in the picture. Needs no display. Equal scenes give equal bytes. Error: there is nothing to show.
Result<std::string> scene_file_text(const Scene& scene, SceneFormat format, ScenePalette palette);

}  // namespace covaria
