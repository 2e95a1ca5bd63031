// The meanings of the columns of a budget (EA-4/02): stated by people, or by its line of headers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"

namespace covaria {

/// The meaning of a column, in the order in which the keys are listed to people.
enum class BudgetColumn {
    quantity,  ///< symbol of a quantity
    name,      ///< name of the quantity
    value,     ///< estimate of the quantity
    unit,      ///< unit of value and uncertainty
    standard,  ///< u: standard uncertainty
    expanded,  ///< U, or any figure that is divided by a divisor
    limits,    ///< half-width of limits
    divisor,   ///< divisor, or coverage factor k
    distribution,
    nu,            ///< degrees of freedom
    c,             ///< sensitivity coefficient
    contribution,  ///< |c| u
    source,
    unread
};

struct BudgetHead {
    BudgetColumn column = BudgetColumn::unread;
    std::string word = {};          ///< word as it was written
    std::optional<Unit> unit = {};  ///< unit as it was written behind the word
    std::optional<double> k = {};   ///< coverage factor as it was written behind the word: "U (k = 2)"
    bool understood = false;        ///< whether it is known, even where it is not needed
    /// Whether others decide: "quantity" beside a column of symbols is a name.
    bool weak = false;
};

struct BudgetColumnWord {
    BudgetColumn column;
    const char* key;    ///< key of the column: "value"
    const char* title;  ///< title of the column: "estimate"
};
const std::vector<BudgetColumnWord>& budget_column_words();

/// The meaning of a header; `unread` and not understood where not all of it is known.
BudgetHead budget_head_of(const std::string& header);
/// The coverage factor in a header, which is taken off `words`: 2 of "Expanded uncertainty (k = 2)"; empty
/// where none stands there.
std::optional<double> coverage_factor_in(std::string& words);
/// Whether headers make a budget: a quantity or name, an uncertainty, and a third.
bool are_budget_heads(const std::vector<BudgetHead>& heads);
/// The word that people state where a header says which column it is.
inline constexpr const char* as_headed = "?";
/// The columns as they were typed: "name,value,unit,limits,divisor,-,?". Error{usage}: a word that is none.
Result<std::vector<BudgetHead>> stated_budget_columns(const std::vector<std::string>& words);
/// Refuses columns of which two mean the same, or among which there is no uncertainty or no quantity.
/// Error{usage}.
Result<void> check_budget_columns(const std::vector<BudgetHead>& heads);

}  // namespace covaria
