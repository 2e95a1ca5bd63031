#include "core/base/file_names.h"

#include <string_view>

#include "core/base/small_letters.h"
#include "core/base/utf8.h"

namespace covaria {

namespace {

bool is_letter_or_digit(unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Blanks, signs and controls beyond ASCII that have no place in a name: U+0080 to U+00BF, general punctuation
// (U+2000 to U+206F, with marks that turn the direction of writing), byte order marks.
bool is_sign(std::string_view character) {
    return character.starts_with("\xC2") || character.starts_with("\xE2\x80") ||
           character.starts_with("\xE2\x81") || character == "\xEF\xBB\xBF";
}

}  // namespace

std::string file_name_part(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const auto first = static_cast<unsigned char>(text[at]);
        std::size_t length = 1;
        while (first >= 0xC0 && at + length < text.size() &&
               (static_cast<unsigned char>(text[at + length]) & 0xC0) == 0x80)
            ++length;
        const std::string_view character(text.data() + at, length);
        const bool kept = first < 0x80 ? is_letter_or_digit(first) || first == '_'
                                       : valid_utf8(character) == length && !is_sign(character);
        if (kept)
            out += character;
        else if (!out.empty() && out.back() != '-')
            out += '-';
        at += length;
    }
    while (!out.empty() && out.back() == '-') out.pop_back();
    return out;
}

std::string FileNames::unique(const std::string& stem, const std::string& ending) {
    constexpr std::size_t longest = 200;  // bytes; file systems take 255
    std::string cut = stem.substr(0, longest);
    if (cut.size() < stem.size()) cut.resize(valid_utf8(cut));
    for (int number = 1;; ++number) {
        const std::string name = cut + (number == 1 ? "" : "-" + std::to_string(number)) + ending;
        if (taken_.insert(in_small_letters(name)).second) return name;
    }
}

}  // namespace covaria
