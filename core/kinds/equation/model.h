// Measurement model "measurement equation": any equations that the user types.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor measurement_equation_model();

}  // namespace covaria
