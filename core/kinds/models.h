// The list of measurement models. models.cpp is the only file that names them.
//
// To add a model: core/kinds/<family>/model.{h,cpp}, two lines in models.cpp, projects/x.covaria,
// resources/help/x.md, its tests in tests/core/kinds/<family>. Nothing in ui, viz, report or app
// (docs/add-a-model.md).
#pragma once

#include <string>
#include <vector>

#include "core/model/model_descriptor.h"

namespace covaria {

const std::vector<ModelDescriptor>& model_registry();
const ModelDescriptor* find_model(const std::string& id);  ///< null if there is none

}  // namespace covaria
