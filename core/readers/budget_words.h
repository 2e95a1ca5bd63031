// The words that head the columns of an uncertainty budget, in one table: those of EA-4/02 in six languages,
// DAkkS-DKD-3, UKAS M3003 and NIST TN 1297.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/readers/budget_columns.h"

namespace covaria {

struct BudgetWord {
    /// Column of the words; `unread`: known, and not needed (serial numbers, shares in percent).
    BudgetColumn column;
    const char* language;  ///< language by ISO 639-1
    const char* words;     ///< words in small letters
    bool weak = false;     ///< whether it gives way to what else the head says: "value" in "value ±"
};
std::span<const BudgetWord> budget_words();

struct BudgetSymbol {
    BudgetColumn column;
    const char* symbol;  ///< capital letters told apart, without signs for the index: "u(xi)" for u(x_i)
};
std::span<const BudgetSymbol> budget_symbols();

/// The words of a text as they are compared: capitals, accents and their spellings without (ä, ae), marks and
/// the s of plurals do not count.
std::vector<std::string> folded_words(const std::string& text);

/// The meaning of all the words and symbols of a head together. It is empty where one of them is not known,
/// or they say two things; nothing is concluded from a part of a head.
struct HeadMeaning {
    BudgetColumn column = BudgetColumn::unread;
    bool weak = false;
};
std::optional<HeadMeaning> meaning_of_head(const std::string& head);

}  // namespace covaria
