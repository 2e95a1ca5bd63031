// Assets of ballbar measurements: the ballbars, the robot that repeats.
#pragma once

#include "core/model/asset.h"

namespace covaria {

/// Telescopic ballbars that measure to one ball at once (Brosed et al., 2.1).
AssetDescriptor ballbar_set_kind();
/// Deviation of a robot from a pose it was sent to before (ISO 9283).
AssetDescriptor robot_repeatability_kind();

}  // namespace covaria
