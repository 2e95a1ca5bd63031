// A text as a cell of a CSV file.
#pragma once

#include <string>

namespace covaria {

/// Quoted where RFC 4180 asks for it. A text that a spreadsheet would compute (it begins with =, +, -, @, a
/// tab or a line end, and is no number) gets an apostrophe in front: it is shown, and does nothing.
std::string csv_text(const std::string& text);

}  // namespace covaria
