// Measurement model "force-moment channels": what a channel of a multi-axis sensor says, used alone or with
// other loads.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor force_channels_model();

}  // namespace covaria
