// The assets of this family: what stands around the measurement and influences no number.
#pragma once

#include "core/model/asset.h"

namespace covaria {

AssetDescriptor context_mesh_kind();

}  // namespace covaria
