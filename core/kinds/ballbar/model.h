// Measurement model "TCP from ballbars": the tool centre point of a robot by simultaneous multilateration.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor tcp_from_ballbars_model();

}  // namespace covaria
