// Lighting of surfaces, and dashes of thin lines: shaders that extend VTK's own.
#pragma once

#include <vtkActor.h>

#include <Eigen/Core>

namespace covaria::detail {

enum class Surface {
    matt,   ///< bodies: a key light from the left above, and the sky
    clear,  ///< ellipsoids: denser at the rim
    dashed  ///< lines with dashes of one length in the picture
};

/// Extends the shaders of an actor made by Shapes.
void shade(vtkActor* actor, Surface surface);
/// Facts on a picture that the shaders of an actor need: the way up, seen from the eye, and its size
/// in pixels with the pixels of a point.
struct ShadingView {
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();
    double width = 1.0, height = 1.0, pixels_per_point = 1.0;
    bool is_cut = false;  ///< by a section: the far side of ellipsoids is seen through it
};
void set_view(vtkActor* actor, Surface surface, const ShadingView& view);

}  // namespace covaria::detail
