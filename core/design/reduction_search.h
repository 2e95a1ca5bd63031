// The reverse question: which components of uncertainty to reduce, and how far, so that all targets are met
// as cheaply as possible.
#pragma once

#include "core/design/cheapest_reductions.h"
#include "core/design/search.h"

namespace covaria::detail {

struct FoundReductions {
    std::vector<double> factors;  ///< the smallest there are where they do not suffice
    double cost = 0.0;
    std::vector<double> prices;  ///< prices of the targets: cost per SI unit less of each
    std::vector<DesignCost> front;
};

/// Exact where what is reduced adds to the variances and coverage factors stay; coverage factors that change
/// with the effective degrees of freedom are taken at the solution, which is repeated until they stay. Error
/// (bad_input): the variances are not a sum over what is reduced. Throws Stopped.
Result<FoundReductions> find_reductions(SearchBook& book);

}  // namespace covaria::detail
