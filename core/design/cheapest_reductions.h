// The cheapest reductions of components of uncertainty that keep variances below their limits.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/project/design.h"

namespace covaria::detail {

/// Variance of output k relative to its limit: rest(k) + sum over j of part(k, j) f_j², at most 1.
struct ReductionTask {
    std::vector<DesignReduction> reductions;
    Eigen::MatrixXd part;
    Eigen::VectorXd rest;
};

struct CheapestReductions {
    bool possible = false;  ///< false: all factors are the smallest there are
    std::vector<double> factors;
    double cost = 0.0;
    Eigen::VectorXd
        multipliers;  ///< falling cost per rise of each limit (which is 1); zero: it does not bind
};

double cost_of(const DesignReduction& reduction, double factor);

/// Convex in the f_j²: by a primal-dual interior point method (Boyd and Vandenberghe, Convex
/// Optimization, 11.7) until the duality gap is below 1e-12 of the sum of the prices.
CheapestReductions cheapest_reductions(const ReductionTask& task);

}  // namespace covaria::detail
