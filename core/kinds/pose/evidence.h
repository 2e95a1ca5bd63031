// Least-squares frames as evidence for or against the stated uncertainties of their points.
#pragma once

#include "core/kinds/points/component_evidence.h"
#include "core/kinds/pose/tables.h"

namespace covaria::pose {

/// Evidence of all sets that are tested; `fits`: of these inputs. A figure is what is typed for one axis of
/// the points of a frame, or one kind of reading of the instrument that measured them.
ComponentEvidence evidence_of(const PoseSetup& setup, const InputSet& inputs,
                              const std::vector<FrameFit>& fits);

}  // namespace covaria::pose
