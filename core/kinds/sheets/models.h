// The measurement models of test sheets: what laboratories are asked for by the name of a standard, with the
// uncertainty of its figures.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor distance_meter_model();
ModelDescriptor theodolite_model();
ModelDescriptor force_proving_model();

}  // namespace covaria
