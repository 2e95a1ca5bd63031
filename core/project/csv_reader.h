// Text of a CSV file (or of the clipboard) to rows of texts: RFC 4180 with comma, semicolon or tab.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// A line of more cells is refused before it is kept.
inline constexpr std::size_t most_csv_columns = 100'000;

struct CsvRow {
    int line = 0;  ///< 1-based, where the row begins
    std::vector<std::string> cells;
};

struct CsvText {
    char separator = ',';
    std::vector<CsvRow> rows;
};

/// Lines that begin with '#' and rows without any content are left out; unquoted cells are trimmed; a byte
/// order mark is accepted. Without `separator` it is found from the first row: tab before semicolon before
/// comma. Errors (with `line`): not UTF-8, a quote that is not closed, text after a closing quote.
Result<CsvText> read_csv(std::string_view text, std::optional<char> separator = {});

/// The separator that the first line with content suggests; what stands in quotes does not count.
char csv_separator(std::string_view text);
/// Row by row, for files that are not to be kept whole; errors as `read_csv`. False: no more are wanted.
using TakeCsvRow = std::function<bool(CsvRow&&)>;
Result<void> scan_csv(std::string_view text, char separator, const TakeCsvRow& take);

/// A number as people write it: leading '+', the minus sign U+2212, and a decimal comma if `decimal_comma`.
/// Empty if it is not one finite number.
std::optional<double> csv_number(std::string text, bool decimal_comma);

}  // namespace covaria
