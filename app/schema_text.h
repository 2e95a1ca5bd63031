// Models and assets described as plain text for the terminal.
#pragma once

#include <string>

#include "core/model/model_descriptor.h"

namespace covaria {

std::string description_of(const ModelDescriptor& model);
std::string description_of(const AssetDescriptor& asset);
/// What the axes of a study can vary.
std::string study_targets_text();

}  // namespace covaria
