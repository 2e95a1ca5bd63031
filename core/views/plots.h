// The charts of a result as plot specifications.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/text/display_units.h"
#include "core/text/document_language.h"
#include "core/text/plot_specification.h"

namespace covaria {

// Where there is nothing to show, the specification has no series and its title says what to do. `language`
// is that of words and numbers.

/// The histogram with mean, coverage interval, fitted normal and first-order normal. It needs Monte Carlo.
PlotSpecification histogram_plot(const UncertaintyResult& result, std::size_t output,
                                 const DisplayUnits& units = {}, const DocumentLanguage& language = {});
/// Quantiles against those of a normal distribution. The chart needs Monte Carlo.
PlotSpecification normal_quantile_plot(const UncertaintyResult& result, std::size_t output,
                                       const DisplayUnits& units = {}, const DocumentLanguage& language = {});
/// The chart of the largest contributions to an output (at most `rows`, the rest summed).
PlotSpecification contribution_plot(const UncertaintyResult& result, std::size_t output,
                                    const DocumentLanguage& language = {}, std::size_t rows = 12);
/// Outputs of a group (all where it is empty), which the matrix and its chart show.
std::vector<std::size_t> outputs_to_correlate(const UncertaintyResult& result, const std::string& group);
/// The chart of the correlation matrix of these outputs.
PlotSpecification correlation_plot(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                                   const DocumentLanguage& language = {});
/// The chart of running u (and mean) against trials with two standard errors.
PlotSpecification convergence_plot(const UncertaintyResult& result, std::size_t output,
                                   const DisplayUnits& units = {}, const DocumentLanguage& language = {});

}  // namespace covaria
