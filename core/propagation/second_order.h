// Second-order terms of the law of propagation (NOTE to JCGM 100 5.1.2).
#pragma once

#include <Eigen/Core>
#include <stop_token>

#include "core/base/error.h"
#include "core/propagation/first_order.h"

namespace covaria::detail {

struct SecondOrder {
    Eigen::VectorXd variance;  ///< to be added to the first-order variance
    Eigen::VectorXd shift;     ///< 1/2 sum f_ii u_i^2: for information, not added to the estimate
};

/// For independent, symmetric components. Derivatives of the Jacobian by central differences of a tenth of
/// the standard uncertainty. Error: cancelled; numeric when the model has no derivatives nearby.
Result<SecondOrder> second_order_terms(const MeasurementModel& model, const InputSet& inputs,
                                       const LawOfPropagation& law, const std::stop_token& stop);

}  // namespace covaria::detail
