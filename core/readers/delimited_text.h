// Tables as text: cells between tabs, semicolons, commas or blanks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/project/csv_reader.h"

namespace covaria {

struct DelimitedText {
    char separator = ',';  ///< the separator; ' ' stands for any number of blanks
    bool decimal_comma = false;
    Message words() const;  ///< in words: "columns between semicolons"
};

/// The format by the first line with content: tab before semicolon before comma before blanks. Commas between
/// digits in a line of blanks are decimal ones.
DelimitedText delimited_text_of(std::string_view text);

/// Scans lines with content as `scan_csv` does; lines that begin with '#', '!' or '//', and "sep=;", are
/// counted instead.
Result<void> scan_table(std::string_view text, const DelimitedText& format, std::size_t& comments,
                        const TakeCsvRow& take);

/// The cells of the first line with content; empty where there is none.
std::vector<std::string> first_cells(std::string_view text, const DelimitedText& format);

/// The words between blanks, of which one in double quotes may hold blanks; not more than `most_csv_columns`
/// + 1 of them.
std::vector<std::string> blank_separated(std::string_view line);

}  // namespace covaria
