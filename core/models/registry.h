// The list of measurement models. registry.cpp is the only file that names them.
//
// To add a model: core/models/x.{h,cpp}, one line in registry.cpp, projects/x.covaria, resources/help/x.md,
// its tests in tests/core/models. Nothing in ui, viz, report or app.
#pragma once

#include <string>
#include <vector>

#include "core/model/model_descriptor.h"

namespace covaria {

const std::vector<ModelDescriptor>& model_registry();
const ModelDescriptor* find_model(const std::string& id);  ///< null if there is none

}  // namespace covaria
