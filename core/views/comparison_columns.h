// Tables and charts of one result beside another.
#pragma once

#include <vector>

#include "core/result/comparison.h"
#include "core/text/document_language.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria {

// Tables read the comparison when they are asked for cells.

/// A row for each of these outputs (indices into `ResultComparison::outputs`), in the units of `after`.
Table compared_results_table(const ResultComparison& comparison, std::vector<std::size_t> outputs);
Table compared_results_table(const ResultComparison& comparison);  ///< all of them

struct ComparedPlace {
    std::size_t output = 0;  ///< index into `ResultComparison::outputs`
    ComparedComponent component = {};
};
/// A row for each place. `language`: of the labels of rows.
Table compared_budget_table(const ResultComparison& comparison, std::vector<ComparedPlace> places,
                            const DocumentLanguage& language = {});
/// Names of the components of these places that tell them apart.
std::vector<Text> compared_labels(const ResultComparison& comparison,
                                  const std::vector<ComparedPlace>& places, const DocumentLanguage& language);
/// Every component of the output, by falling change.
std::vector<ComparedPlace> compared_places(const ResultComparison& comparison, std::size_t output);
/// Whether its part of the variance is another, beyond rounding.
bool has_changed(const ResultComparison& comparison, const ComparedPlace& place);

/// Distributions over each other: trials where they ran, else that of the law of propagation.
PlotSpecification compared_distributions_plot(const ResultComparison& comparison, std::size_t output,
                                              const DisplayUnits& units = {},
                                              const DocumentLanguage& language = {});
/// The largest changes of the budget as bars (at most `rows`, the rest summed).
PlotSpecification budget_changes_plot(const ResultComparison& comparison, std::size_t output,
                                      const DocumentLanguage& language = {}, std::size_t rows = 10);

}  // namespace covaria
