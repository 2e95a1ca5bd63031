// Robots with identified parameters, as assets.
#pragma once

#include "core/model/asset.h"

namespace covaria {

/// A robot with the parameters of an identification by joint trajectories (Wen et al., 2.1).
AssetDescriptor identified_robot_kind();
/// A robot with the parameters of an identification by least squares from measured poses.
AssetDescriptor calibrated_robot_kind();

}  // namespace covaria
