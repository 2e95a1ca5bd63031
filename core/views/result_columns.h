// The tables of a result, each defined once, which all views of it choose from.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/text/document_language.h"
#include "core/text/table.h"

namespace covaria {

// All tables read the result when they are asked for cells. `language` is that of words which print alone
// says, and of heads with names.

/// The table of results, with a row for each of these outputs.
Table results_table(const UncertaintyResult& result, std::vector<std::size_t> outputs);
Table results_table(const UncertaintyResult& result);  ///< table of all of them
/// The table of results with the answers of the requirements for each row: "target", "U/target", "met".
Table results_table(const UncertaintyResult& result, std::vector<std::size_t> outputs,
                    const std::vector<RequirementResult>& verdicts, const DocumentLanguage& language = {});
/// The heads of the columns of an interval's ends, "95 % interval, low"; without a probability where rows
/// differ in it.
struct IntervalHeads {
    std::string low, high;
};
IntervalHeads interval_heads(std::optional<double> probability, const DocumentLanguage& language);
/// Keys of the columns "U, ... held", one for each contributor.
std::vector<std::string> contributor_keys(const UncertaintyResult& result);

/// The least number of digits of sensitivity coefficients: -575 nm/K, whatever the digits of U.
inline constexpr int sensitivity_digits = 3;

struct BudgetPlace {
    std::size_t output = 0, row = 0;
};
/// The table of budgets, with a row for each place.
Table budget_table(const UncertaintyResult& result, std::vector<BudgetPlace> places,
                   const DocumentLanguage& language = {});
std::vector<BudgetPlace> budget_places(const UncertaintyResult& result, std::size_t output);
/// Places without components whose contribution is only rounding of a sensitivity coefficient of zero.
std::vector<BudgetPlace> places_that_count(const UncertaintyResult& result, std::size_t output);
std::vector<BudgetRow> rows_at(const UncertaintyResult& result, const std::vector<BudgetPlace>& places);

/// A row about quantities with equal components, or about one share of a quantity.
struct InputRow {
    std::vector<std::size_t> quantities;
    std::optional<std::size_t> share = {};
    /// Whether it stands below the row of its quantity, whose symbol and estimate it leaves out.
    bool part = false;
};
Table inputs_table(const InputSet& inputs, std::vector<InputRow> rows);
/// Rows for every share of every quantity.
std::vector<InputRow> all_shares(const InputSet& inputs);

/// Correlation coefficients of components: a row for each pair.
Table input_correlations_table(const InputSet& inputs, std::vector<ComponentCorrelation> pairs);
/// The correlations that were stated or observed, and the +-1 of quantities that add their components.
std::vector<ComponentCorrelation> all_correlations(const InputSet& inputs);

/// Correlation coefficients of outputs: "output symbol" and a column for each of the outputs.
Table correlation_table(const UncertaintyResult& result, const std::vector<std::size_t>& outputs);
/// Joint coverage regions of the groups of measurands.
Table regions_table(const UncertaintyResult& result);

}  // namespace covaria
