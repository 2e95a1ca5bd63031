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

/// The most cells of a line; a line of more is refused before it is kept.
inline constexpr std::size_t most_csv_columns = 100'000;

struct CsvRow {
    int line = 0;  ///< the line that the row begins in, from 1
    std::vector<std::string> cells;
};

struct CsvText {
    char separator = ',';
    std::vector<CsvRow> rows;
};

/// The rows of a text. Lines that begin with '#' and rows without any content are left out; unquoted cells
/// are trimmed; a byte order mark is accepted. Without `separator` it is found from the first row: tab before
/// semicolon before comma. Errors (with `line`): not UTF-8, a quote that is not closed, text after a closing
/// quote.
Result<CsvText> read_csv(std::string_view text, std::optional<char> separator = {});

/// The separator that the first line with content suggests; text in quotes does not count.
char csv_separator(std::string_view text);
/// The taker of rows one by one, for files that are not to be kept whole; it returns false when it wants no
/// more of them. `scan_csv` has the errors of `read_csv`.
using TakeCsvRow = std::function<bool(CsvRow&&)>;
Result<void> scan_csv(std::string_view text, char separator, const TakeCsvRow& take);

/// The number that people write with a leading '+', the minus sign U+2212, or a decimal comma if
/// `decimal_comma`. Empty if the text is not one finite number.
std::optional<double> csv_number(std::string text, bool decimal_comma);

}  // namespace covaria
