// The tables of a result, each defined once: what all views of it choose from.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/text/document_language.h"
#include "core/text/table.h"

namespace covaria {

// All read the result when they are asked for cells. `language`: of what only print says in words of its own,
// and of heads with names.

/// A row for each of these outputs.
Table results_table(const UncertaintyResult& result, std::vector<std::size_t> outputs);
Table results_table(const UncertaintyResult& result);  ///< all of them
/// With what the requirements say of each row: "target", "U/target", "met".
Table results_table(const UncertaintyResult& result, std::vector<std::size_t> outputs,
                    const std::vector<RequirementResult>& verdicts, const DocumentLanguage& language = {});
/// "95 % interval, low": of the columns of its ends; without a probability where rows differ in it.
struct IntervalHeads {
    std::string low, high;
};
IntervalHeads interval_heads(std::optional<double> probability, const DocumentLanguage& language);
/// Keys of the columns "U, ... held", one for each contributor.
std::vector<std::string> contributor_keys(const UncertaintyResult& result);

/// At the least, of sensitivity coefficients: -575 nm/K, whatever the digits of U.
inline constexpr int sensitivity_digits = 3;

struct BudgetPlace {
    std::size_t output = 0, row = 0;
};
/// A row for each place.
Table budget_table(const UncertaintyResult& result, std::vector<BudgetPlace> places,
                   const DocumentLanguage& language = {});
std::vector<BudgetPlace> budget_places(const UncertaintyResult& result, std::size_t output);
/// Without components whose contribution is only rounding of a sensitivity coefficient of zero.
std::vector<BudgetPlace> places_that_count(const UncertaintyResult& result, std::size_t output);
std::vector<BudgetRow> rows_at(const UncertaintyResult& result, const std::vector<BudgetPlace>& places);

/// A row about quantities with equal components, or about one share of a quantity.
struct InputRow {
    std::vector<std::size_t> quantities;
    std::optional<std::size_t> share = {};
    bool part = false;  ///< below the row of its quantity, whose symbol and estimate it leaves out
};
Table inputs_table(const InputSet& inputs, std::vector<InputRow> rows);
/// Every share of every quantity.
std::vector<InputRow> all_shares(const InputSet& inputs);

/// Correlation coefficients of components: a row for each pair.
Table input_correlations_table(const InputSet& inputs, std::vector<ComponentCorrelation> pairs);
/// Those that were stated or observed, and the +-1 of quantities that add their components.
std::vector<ComponentCorrelation> all_correlations(const InputSet& inputs);

/// Correlation coefficients of outputs: "output symbol" and a column for each of the outputs.
Table correlation_table(const UncertaintyResult& result, const std::vector<std::size_t>& outputs);
/// Joint coverage regions of the groups of measurands.
Table regions_table(const UncertaintyResult& result);

}  // namespace covaria
