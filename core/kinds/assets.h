// The list of asset kinds. assets.cpp is the only file that names them.
#pragma once

#include <string>
#include <vector>

#include "core/model/asset.h"

namespace covaria {

const std::vector<AssetDescriptor>& asset_registry();
const AssetDescriptor* find_asset_kind(const std::string& kind);  ///< null if there is none

}  // namespace covaria
