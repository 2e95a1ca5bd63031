// Models and assets described as plain text for the terminal.
#pragma once

#include <sstream>
#include <string>

#include "core/model/model_descriptor.h"

namespace covaria {

std::string description_of(const ModelDescriptor& model);
std::string description_of(const AssetDescriptor& asset);
/// Writes lines of at most 100 characters, each behind the indent.
void write_wrapped(std::ostringstream& out, const std::string& text, const std::string& indent);
/// Lists what the axes of a study can vary.
std::string study_targets_text();

}  // namespace covaria
