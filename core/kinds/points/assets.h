// Assets that give points: artefacts, standards, data sheets.
#pragma once

#include "core/model/asset.h"

namespace covaria {

/// An artefact with calibrated points, measured repeatedly (Porath et al., 2.1, Eqs 1-3).
AssetDescriptor artefact_points_kind();
/// A calibrated length measured in several positions (Porath et al., 2.2, Eqs 4-6).
AssetDescriptor length_standard_kind();
/// A manufacturer's figure for the uncertainty of a measured point.
AssetDescriptor point_specification_kind();

}  // namespace covaria
