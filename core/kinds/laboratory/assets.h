// The assets of this family: what a laboratory is accredited for.
#pragma once

#include "core/model/asset.h"

namespace covaria {

AssetDescriptor best_capability_kind();

}  // namespace covaria
