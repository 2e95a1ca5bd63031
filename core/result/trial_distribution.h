// The distribution function of a Monte Carlo output, kept after the trials are gone.
#pragma once

#include <vector>

namespace covaria {

/// Points (value, share of the trials below it), both rising; equal values are a jump. Between the points
/// the function is linear. The first and last value are the smallest and greatest of all trials.
struct TrialDistribution {
    std::vector<double> values;
    std::vector<double> shares;

    /// Share of the trials in [low, high]; limits may be infinite. 0 without trials.
    double inside(double low, double high) const;

private:
    double below(double limit) const;  ///< share of trials < limit
    double up_to(double limit) const;  ///< share of trials <= limit
};

}  // namespace covaria
