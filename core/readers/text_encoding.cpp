#include "core/readers/text_encoding.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/utf8.h"
#include "core/readers/gsi_text.h"

namespace covaria {

namespace {

/// The signs 0x80 to 0x9F of Windows-1252; 0: not used.
constexpr std::array<std::uint16_t, 32> windows_signs{
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void append(std::string& text, std::uint32_t code) {
    const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xC0 | code >> 6);
    } else if (code < 0x10000) {
        byte(0xE0 | code >> 12);
        byte(0x80 | (code >> 6 & 0x3F));
    } else {
        byte(0xF0 | code >> 18);
        byte(0x80 | (code >> 12 & 0x3F));
        byte(0x80 | (code >> 6 & 0x3F));
    }
    byte(0x80 | (code & 0x3F));
}

/// The text in UTF-8. Halves of pairs without their other half become '?'.
std::string utf8_of_utf16(std::string_view bytes, bool big_endian) {
    const auto unit = [&](std::size_t at) {
        const auto first = static_cast<unsigned char>(bytes[at]),
                   second = static_cast<unsigned char>(bytes[at + 1]);
        return static_cast<std::uint32_t>(big_endian ? first << 8 | second : second << 8 | first);
    };
    std::string text;
    text.reserve(bytes.size() / 2);
    for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
        std::uint32_t code = unit(at);
        if (code >= 0xD800 && code < 0xE000) {
            const std::uint32_t low = at + 3 < bytes.size() ? unit(at + 2) : 0;
            const bool pair = code < 0xDC00 && low >= 0xDC00 && low < 0xE000;
            code = pair ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00) : '?';
            if (pair) at += 2;
        }
        append(text, code);
    }
    return text;
}

bool keeps_its_bytes(std::string_view bytes) {
    constexpr std::string_view ole = "\xD0\xCF\x11\xE0", zip = "PK\x03\x04";
    return bytes.starts_with(ole) || bytes.starts_with(zip);
}

}  // namespace

std::string utf8_of_windows(std::string_view text) {
    if (valid_utf8(text) == text.size()) return std::string(text);
    std::string converted;
    for (const char c : text) {
        std::uint32_t code = static_cast<unsigned char>(c);
        if (code >= 0x80 && code < 0xA0) code = windows_signs[code - 0x80];
        append(converted, code == 0 && c != 0 ? '?' : code);
    }
    return converted;
}

std::string text_for_readers(std::string bytes) {
    if (keeps_its_bytes(bytes)) return bytes;
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
        bytes = utf8_of_utf16(std::string_view(bytes).substr(2), bytes[0] == '\xFE');
    const std::string_view beginning = without_byte_order_mark(bytes);
    if (is_gsi(beginning)) return bytes;
    if (!beginning.starts_with("<")) bytes = utf8_of_windows(bytes);
    if (bytes.find('\n') == std::string::npos) std::replace(bytes.begin(), bytes.end(), '\r', '\n');
    return bytes;
}

}  // namespace covaria
