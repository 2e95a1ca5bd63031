// Models, assets and parts of projects described for programs: `covaria describe --json`.
#pragma once

#include <string>

#include "core/model/model_descriptor.h"

namespace covaria {

/// Ids and titles of everything that has a description.
std::string list_of_descriptions_json();
std::string description_json(const ModelDescriptor& model);
std::string description_json(const AssetDescriptor& asset);

}  // namespace covaria
