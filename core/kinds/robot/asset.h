// The asset "serial robot".
#pragma once

#include "core/model/asset.h"

namespace covaria {

/// An arm of rotating joints (Wen et al., Eq. 5).
AssetDescriptor serial_robot_kind();

}  // namespace covaria
