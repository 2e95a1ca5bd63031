#include "viz/vtk/section_cut.h"

#include <vtkMapper.h>
#include <vtkProperty.h>

namespace covaria::detail {

void SectionCut::set(const std::optional<SectionPlane>& section, const Eigen::Vector3d& origin,
                     ScenePalette palette) {
    is_on_ = section.has_value();
    inside_ = inside_colour(palette);
    if (!section) return;
    Eigen::Vector3d at = Eigen::Vector3d::Zero(), kept = Eigen::Vector3d::Zero();
    at[section->axis] = section->at - origin[section->axis];
    kept[section->axis] = section->hides_high ? -1.0 : 1.0;
    plane_->SetOrigin(at.data());
    plane_->SetNormal(kept.data());
}

void SectionCut::apply(vtkActor& actor) const {
    actor.GetMapper()->SetClippingPlanes(is_on_ ? planes_.GetPointer() : nullptr);
}

void SectionCut::apply_to_mesh(vtkActor& actor) const {
    apply(actor);
    if (is_on_ == (actor.GetBackfaceProperty() != nullptr)) return;
    if (!is_on_) return actor.SetBackfaceProperty(nullptr);
    vtkNew<vtkProperty> flat;
    flat->DeepCopy(actor.GetProperty());
    flat->SetColor(inside_.red / 255.0, inside_.green / 255.0, inside_.blue / 255.0);
    flat->SetAmbient(1.0);
    flat->SetDiffuse(0.0);
    actor.SetBackfaceProperty(flat);
}

}  // namespace covaria::detail
