// Measurement model "observations in groups": mean of observations made on several days or with several
// instruments, by analysis of variance.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor group_observations_model();

}  // namespace covaria
