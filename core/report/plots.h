// The charts of a result as plot specifications.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/report/plot_specification.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

/// Histogram with mean, coverage interval, fitted normal and first-order normal. Needs Monte Carlo.
PlotSpecification histogram_plot(const UncertaintyResult& result, std::size_t output);
/// Quantiles against those of a normal distribution. Needs Monte Carlo.
PlotSpecification normal_quantile_plot(const UncertaintyResult& result, std::size_t output);
/// The largest contributions to an output (at most `rows`, the rest summed).
PlotSpecification contribution_plot(const UncertaintyResult& result, std::size_t output,
                                    std::size_t rows = 12);
/// Correlation matrix of a group's outputs (empty group: all).
PlotSpecification correlation_plot(const UncertaintyResult& result, const std::string& group);
/// Running u (and mean) against trials with two standard errors.
PlotSpecification convergence_plot(const UncertaintyResult& result, std::size_t output);

}  // namespace covaria
