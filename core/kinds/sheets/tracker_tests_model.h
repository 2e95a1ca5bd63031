// The measurement model "two-face and length tests of a tracker" (ISO 10360-10, ASME B89.4.19).
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor tracker_tests_model();

}  // namespace covaria
