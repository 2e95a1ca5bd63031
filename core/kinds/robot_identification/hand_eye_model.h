// Measurement model "hand-eye": where an instrument and its target are on a robot and beside it.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor hand_eye_model();

}  // namespace covaria
