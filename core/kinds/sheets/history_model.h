// The measurement model "history of an instrument".
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor history_model();

}  // namespace covaria
