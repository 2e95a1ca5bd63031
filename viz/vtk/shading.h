// How surfaces are lit, and how thin lines are dashed: shaders that VTK's own are extended by.
#pragma once

#include <vtkActor.h>

#include <Eigen/Core>

namespace covaria::detail {

enum class Surface {
    matt,   ///< bodies: a key light from the left above, and the sky
    clear,  ///< ellipsoids: denser at the rim
    dashed  ///< lines with dashes of one length in the picture
};

/// Of an actor made by Shapes.
void shade(vtkActor* actor, Surface surface);
/// What the shaders of an actor need to know of a picture: which way is up, seen from the eye, and its size
/// in pixels with the pixels of a point.
struct ShadingView {
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();
    double width = 1.0, height = 1.0, pixels_per_point = 1.0;
};
void set_view(vtkActor* actor, Surface surface, const ShadingView& view);

}  // namespace covaria::detail
