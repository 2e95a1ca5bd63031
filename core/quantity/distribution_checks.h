// Checks of the parameters of distributions.
#pragma once

#include <string>

#include "core/base/message.h"
#include "core/quantity/distribution.h"

namespace covaria::detail {

/// Says what is wrong with the parameters, naming the first bad one; empty if nothing is.
Message distribution_problem(const DistributionParameters& parameters);

}  // namespace covaria::detail
