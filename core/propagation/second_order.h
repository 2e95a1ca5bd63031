// Second-order terms of the law of propagation (NOTE to JCGM 100 5.1.2).
#pragma once

#include <Eigen/Core>
#include <stop_token>

#include "core/base/error.h"
#include "core/propagation/first_order.h"

namespace covaria::detail {

struct SecondOrder {
    Eigen::VectorXd variance;  ///< term to be added to the first-order variance
    Eigen::VectorXd shift;     ///< 1/2 sum f_ii u_i^2: for information, not added to the estimate
};

/// Terms for independent, symmetric components. Derivatives of the Jacobian, which is exact, by differences
/// whose steps are halved until their extrapolation to no step at all (Ridders, Advances in Engineering
/// Software 4 (1982) 75) is known. Error: cancelled; numeric when the model has no derivatives nearby, or
/// none of second and third order.
Result<SecondOrder> second_order_terms(const MeasurementModel& model, const InputSet& inputs,
                                       const LawOfPropagation& law, const std::stop_token& stop);

}  // namespace covaria::detail
