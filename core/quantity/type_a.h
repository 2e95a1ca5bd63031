// Type A evaluation of standard uncertainty (JCGM 100 4.2, H.2, H.5).
#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"

namespace covaria {

struct TypeA {
    double mean = 0.0;
    double standard_deviation = 0.0;    ///< that of a single observation, n - 1 (JCGM 100 4.2.2)
    double standard_uncertainty = 0.0;  ///< that of the mean: s/sqrt(n) (4.2.3)
    double degrees_of_freedom = 0.0;    ///< n - 1
};

/// Error: fewer than two observations, or one that is not finite.
Result<TypeA> type_a_evaluation(std::span<const double> observations);

/// Series of one procedure taken together (JCGM 100 4.2.4, H.3.6): s_p^2 = sum nu_i s_i^2 / sum nu_i.
struct PooledDeviation {
    double standard_deviation = 0.0;  ///< s_p of a single observation
    double degrees_of_freedom = 0.0;  ///< sum of n_i - 1
};
/// Error: no series, or one that `type_a_evaluation` refuses.
Result<PooledDeviation> pooled_deviation(std::span<const std::vector<double>> series);

/// Covariance u(xbar, ybar) of the means of two series observed simultaneously (JCGM 100 5.2.3, Eq. 17).
Result<double> covariance_of_means(std::span<const double> x, std::span<const double> y);

}  // namespace covaria
