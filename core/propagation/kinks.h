// Outputs whose sensitivity coefficients mean nothing where the law of propagation takes them.
#pragma once

#include <vector>

#include "core/propagation/first_order.h"

namespace covaria::detail {

/// Outputs with doubtful coefficients, one entry for each output.
struct DoubtfulCoefficients {
    /// The coefficients on both sides of the estimates stay different however near they are taken (|x| at 0,
    /// max(a, b) at a = b).
    std::vector<bool> has_kink;
    /// The last digits of the estimates change them by more than a tenth: what is left is rounding.
    std::vector<bool> is_rounding;
};

/// Looks for them along one line through the estimates that is parallel to no component. In large models
/// nothing is known: all false.
DoubtfulCoefficients doubtful_coefficients(const MeasurementModel& model, const InputSet& inputs,
                                           const LawOfPropagation& law);

}  // namespace covaria::detail
