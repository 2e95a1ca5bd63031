// Bytes of a file as the text that readers take.
#pragma once

#include <string>
#include <string_view>

namespace covaria {

/// The text for readers: UTF-16 with a byte order mark, and bytes of Windows-1252 in a text that is no UTF-8,
/// become UTF-8; carriage returns without line feeds become line feeds. Workbooks, XML (whose declaration
/// counts) and GSI (whose words have a width in bytes) keep their 8-bit characters. Line and column stay.
std::string text_for_readers(std::string bytes);

/// The text of Windows-1252 in UTF-8; a text in UTF-8 stays.
std::string utf8_of_windows(std::string_view text);

}  // namespace covaria
