// Actors cut at the plane of a section: by clipping planes of VTK, so that nothing is built anew.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

#include <optional>

#include "viz/scene/section_plane.h"
#include "viz/vtk/palette.h"

namespace covaria::detail {

class SectionCut {
public:
    SectionCut() { planes_->AddItem(plane_); }
    /// Takes the plane of the next picture; `origin` is the place in W that is zero to the actors.
    void set(const std::optional<SectionPlane>& section, const Eigen::Vector3d& origin, ScenePalette palette);
    bool is_on() const { return is_on_; }
    /// Cuts an actor where there is a section, else makes it whole again.
    void apply(vtkActor& actor) const;
    /// The same for a mesh, which may be open and gets no faces in the plane: seen from behind it is flat.
    void apply_to_mesh(vtkActor& actor) const;

private:
    bool is_on_ = false;
    Colour inside_;
    vtkNew<vtkPlane> plane_;
    vtkNew<vtkPlaneCollection> planes_;
};

}  // namespace covaria::detail
