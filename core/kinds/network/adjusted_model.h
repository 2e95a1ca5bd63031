// Measurement model "network adjustment": points and stations that follow from what was read between them.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor network_adjustment_model();

}  // namespace covaria
