// The asset "network of sensors".
#pragma once

#include "core/model/asset.h"

namespace covaria {

/// Instruments that measure the same points together (Galetto et al.).
AssetDescriptor sensor_network_kind();

}  // namespace covaria
