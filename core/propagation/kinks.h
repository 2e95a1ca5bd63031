// Outputs that bend sharply where the law of propagation looks at them.
#pragma once

#include <vector>

#include "core/propagation/first_order.h"

namespace covaria::detail {

/// By output: whether its sensitivity coefficients on both sides of the estimates stay different however near
/// they are taken (|x| at 0, max(a, b) at a = b). Looked for along one line through the estimates that is
/// parallel to no component. Of large models nothing is known: all false.
std::vector<bool> outputs_with_kink(const MeasurementModel& model, const InputSet& inputs,
                                    const LawOfPropagation& law);

}  // namespace covaria::detail
