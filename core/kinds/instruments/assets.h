// Assets that measure points.
#pragma once

#include "core/model/asset.h"

namespace covaria {

/// An instrument that measures distance and two angles, standing somewhere.
AssetDescriptor spherical_instrument_kind();

}  // namespace covaria
