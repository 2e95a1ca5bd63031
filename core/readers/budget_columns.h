// What the columns of a budget mean (EA-4/02): stated by people, or by its line of headers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"

namespace covaria {

/// Keys in the order in which they are listed to people.
enum class BudgetColumn {
    quantity,  ///< symbol
    name,      ///< what it is
    value,     ///< estimate
    unit,      ///< of value and uncertainty
    standard,  ///< u: standard uncertainty
    expanded,  ///< U, or any figure that is divided by a divisor
    limits,    ///< half-width
    divisor,   ///< also the coverage factor k
    distribution,
    nu,            ///< degrees of freedom
    c,             ///< sensitivity coefficient
    contribution,  ///< |c| u
    source,
    unread
};

struct BudgetHead {
    BudgetColumn column = BudgetColumn::unread;
    std::string word = {};          ///< as it was written
    std::optional<Unit> unit = {};  ///< as it was written behind it
    std::optional<double> k = {};   ///< likewise: "U (k = 2)"
    bool understood = false;        ///< also where it is known and not needed
    bool weak = false;              ///< "quantity" beside a column of symbols is a name
};

struct BudgetColumnWord {
    BudgetColumn column;
    const char* key;    ///< "value"
    const char* title;  ///< "estimate"
};
const std::vector<BudgetColumnWord>& budget_column_words();

/// What a header means; `unread` and not understood where all of it is not known.
BudgetHead budget_head_of(const std::string& header);
/// "Expanded uncertainty (k = 2)": 2, and it is taken off `words`; empty where none stands there.
std::optional<double> coverage_factor_in(std::string& words);
/// Whether headers make a budget: a quantity or name, an uncertainty, and a third.
bool are_budget_heads(const std::vector<BudgetHead>& heads);
/// What people state where a header says what its column is.
inline constexpr const char* as_headed = "?";
/// As typed: "name,value,unit,limits,divisor,-,?". Error{usage}: a word that is none.
Result<std::vector<BudgetHead>> stated_budget_columns(const std::vector<std::string>& words);
/// Error{usage}: two columns mean the same, or no uncertainty or no quantity is among them.
Result<void> check_budget_columns(const std::vector<BudgetHead>& heads);

}  // namespace covaria
