// Variance reduction: how the trials of a Monte Carlo run were made to tell more than as many plain ones.
#pragma once

#include <string>
#include <string_view>

namespace covaria {

enum class VarianceReduction {
    none,             ///< plain trials (JCGM 101)
    control_variate,  ///< the linear part of each output, whose distribution is known, as its control
    sobol,            ///< Sobol points with a random digital shift in each batch
};
/// Key in files: "none", "control-variate", "sobol".
std::string_view key_of(VarianceReduction reduction);

/// Numbers for the figures of an output.
struct OutputFigures {
    double mean = 0.0;
    double standard_uncertainty = 0.0;
    double low = 0.0, high = 0.0;  ///< ends of the probabilistically symmetric interval
};

/// Effect of variance reduction on one output.
struct ReducedVariance {
    OutputFigures standard_errors;  ///< errors from batches; NaN: too few, or a figure of infinite variance
    OutputFigures gains;            ///< variance of plain trials, as many, over that of the figure; NaN: same
    std::string plain_because;      ///< not empty: nothing was gained by a control variate, and why
};

}  // namespace covaria
