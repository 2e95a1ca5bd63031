// A statement about a quantity as one text, the way people note it in a budget: "75 nm", "U = 0.3 um, k = 2",
// "rectangular 2 ppm". Read once, where it is typed, and written in one form that reads back to the same.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"

namespace covaria {

/// A statement as a budget's row states it: figures in `unit`, or as they are where they have none.
struct TypedStatement {
    std::string kind = {};  ///< key of statement_kinds(), "constant", "observations", "pooled", "sample",
                            ///< "histogram"; empty: nothing
    std::optional<double> a = {}, b = {};
    std::optional<double> degrees_of_freedom = {};
    std::string unit = {};                  ///< unit as a file has it; empty: the row's
    std::vector<double> observations = {};  ///< observations in the unit of the row; edges of a histogram
    std::vector<double> weights = {};       ///< weights of a sample or histogram; empty: all alike
    bool operator==(const TypedStatement&) const = default;
};

/// A word of the program ("rectangular", "to") in the language of who reads; without: English.
using WordOf = std::function<std::string(const std::string& english)>;

/// `unit`: of the row. A figure without a unit is in it, another unit is kept: what a certificate says stays
/// to be read. "%" and "ppm" of a quantity that has a unit are parts of its value. A bare figure is a
/// standard uncertainty, with k or p an expanded one; three or more are observations. With `decimal_comma`
/// "0,5" is a half. English words are read beside those of `word`, whose first letters are enough. Errors:
/// words that are not known, a missing or superfluous figure, a unit of another dimension.
Result<TypedStatement> read_statement(std::string_view text, const Unit& unit, bool decimal_comma = false,
                                      const WordOf& word = {});

/// "U = 0.3 µm, k = 2", `unit` being the row's; empty for a kind that is not about figures or words of its
/// own. `number` writes one.
std::string statement_text(const TypedStatement& statement, const Unit& unit,
                           const std::function<std::string(double)>& number, const WordOf& word = {});

/// The words of statements that have another form in another language.
std::vector<std::string> statement_words();

/// Some statements and what they mean, one a line: for help.
std::string statement_examples();

}  // namespace covaria
