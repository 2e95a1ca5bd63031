// The lists of measurement models and of asset kinds. registries.cpp is the only file that names them.
#pragma once

#include <string>
#include <vector>

#include "core/model/asset.h"
#include "core/model/model_descriptor.h"

namespace covaria {

const std::vector<ModelDescriptor>& model_registry();
const ModelDescriptor* find_model(const std::string& id);  ///< null if there is none

const std::vector<AssetDescriptor>& asset_registry();
const AssetDescriptor* find_asset_kind(const std::string& kind);  ///< null if there is none

}  // namespace covaria
