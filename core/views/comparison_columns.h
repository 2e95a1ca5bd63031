// The tables and charts of one result beside another.
#pragma once

#include <vector>

#include "core/result/comparison.h"
#include "core/text/document_language.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria {

// The tables read the comparison when they are asked for cells.

/// The table of results, with a row for each of these outputs (indices into `ResultComparison::outputs`), in
/// the units of `after`.
Table compared_results_table(const ResultComparison& comparison, std::vector<std::size_t> outputs);
Table compared_results_table(const ResultComparison& comparison);  ///< table of all of them

struct ComparedPlace {
    std::size_t output = 0;  ///< index into `ResultComparison::outputs`
    ComparedComponent component = {};
};
/// The table of budgets, with a row for each place. `language` is that of the labels of rows.
Table compared_budget_table(const ResultComparison& comparison, std::vector<ComparedPlace> places,
                            const DocumentLanguage& language = {});
/// Names of the components of these places that tell them apart.
std::vector<Text> compared_labels(const ResultComparison& comparison,
                                  const std::vector<ComparedPlace>& places, const DocumentLanguage& language);
/// Every component of the output, by falling change.
std::vector<ComparedPlace> compared_places(const ResultComparison& comparison, std::size_t output);
/// Whether the component's part of the variance is another, beyond rounding.
bool has_changed(const ResultComparison& comparison, const ComparedPlace& place);

/// The chart of distributions over each other: those of the trials where they ran, else of the law of
/// propagation.
PlotSpecification compared_distributions_plot(const ResultComparison& comparison, std::size_t output,
                                              const DisplayUnits& units = {},
                                              const DocumentLanguage& language = {});
/// The chart of the largest changes of the budget as bars (at most `rows`, the rest summed).
PlotSpecification budget_changes_plot(const ResultComparison& comparison, std::size_t output,
                                      const DocumentLanguage& language = {}, std::size_t rows = 10);

}  // namespace covaria
