// UTF-8, byte by byte.
#pragma once

#include <cstddef>
#include <string_view>

namespace covaria {

/// Bytes from the front of `text` that are whole characters in UTF-8 (RFC 3629: no overlong forms, no
/// surrogates); all of them if the text is valid.
std::size_t valid_utf8(std::string_view text);

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
inline std::string_view without_byte_order_mark(std::string_view text) {
    return text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text;
}

}  // namespace covaria
