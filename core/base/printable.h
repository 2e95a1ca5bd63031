// Texts of people, without what a terminal or a browser would do instead of show.
#pragma once

#include <string>
#include <string_view>

namespace covaria {

/// Control characters (U+0000 to U+001F, U+007F to U+009F) as signs that are seen: an escape as "␛". Tabs and
/// line ends stay, a carriage return before a line end goes.
std::string printable(std::string_view text);

}  // namespace covaria
