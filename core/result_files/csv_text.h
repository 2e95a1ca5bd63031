// A text as a cell of a CSV file.
#pragma once

#include <string>

namespace covaria {

/// Quoted where RFC 4180 asks for it. A text that a spreadsheet would compute (it begins with =, +, -, @, a
/// tab or a line end, and is no number) gets an apostrophe in front: it is shown, and does nothing.
std::string csv_text(const std::string& text);

/// "u (mm)": the head of a column of a file; the name alone where it has no unit.
std::string csv_head(const std::string& name, const std::string& unit);

}  // namespace covaria
