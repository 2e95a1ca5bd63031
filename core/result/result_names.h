// Names in results follow the project: renaming an asset makes no result out of date.
#pragma once

#include <vector>

#include "core/result/uncertainty_result.h"

namespace covaria {

/// Gives a result the names that its outputs, components and contributors have now. `inputs` are those it was
/// computed from, perhaps under other names; of another number of quantities: nothing changes.
void take_names(UncertaintyResult& result, const std::vector<OutputQuantity>& outputs,
                const InputSet& inputs);

}  // namespace covaria
