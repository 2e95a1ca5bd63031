#include "core/text/digit_groups.h"

#include <array>

namespace covaria {
namespace {

constexpr std::array<std::string_view, 4> spaces{" ", "\u00a0", "\u202f", "\u2009"};

/// Bytes of the space at `at`; 0: there is none.
std::size_t space_at(std::string_view text, std::size_t at) {
    for (const std::string_view space : spaces)
        if (at <= text.size() && text.substr(at).starts_with(space)) return space.size();
    return 0;
}

std::size_t digits_at(std::string_view text, std::size_t at) {
    std::size_t digits = 0;
    while (at + digits < text.size() && text[at + digits] >= '0' && text[at + digits] <= '9') ++digits;
    return digits;
}

std::size_t sign_at_begin(std::string_view text) {
    for (const std::string_view sign : {"+", "-", "\u2212"})
        if (text.starts_with(sign)) return sign.size();
    return 0;
}

bool is_point(std::string_view text, std::size_t at) {
    return at < text.size() && (text[at] == '.' || text[at] == ',') && digits_at(text, at + 1) > 0;
}

}  // namespace

std::size_t length_in_groups(std::string_view text) {
    std::size_t at = sign_at_begin(text);
    const std::size_t first = digits_at(text, at);
    bool any = false;
    at += first;
    while (first > 0 && first <= 3 && space_at(text, at) > 0 &&
           digits_at(text, at + space_at(text, at)) == 3) {
        at += space_at(text, at) + 3;
        any = true;
    }
    if (first > 0 && is_point(text, at)) {
        std::size_t group = digits_at(text, at + 1);
        at += 1 + group;
        while (group == 3 && space_at(text, at) > 0) {
            const std::size_t begin = at + space_at(text, at);
            group = digits_at(text, begin);
            const std::size_t end = begin + group;
            const bool is_of_unit =
                group == 1 && text[begin] == '1' && (end == text.size() || text[end] == '/');
            if (group == 0 || group > 3 || is_of_unit) break;
            at = end;
            any = true;
        }
    }
    const bool goes_on = digits_at(text, at) > 0 || is_point(text, at);
    return any && !goes_on ? at : 0;
}

std::string without_group_spaces(std::string_view number) {
    std::string plain;
    for (std::size_t at = 0; at < number.size();) {
        const std::size_t space = space_at(number, at);
        if (space == 0) plain += number[at];
        at += space == 0 ? 1 : space;
    }
    return plain;
}

}  // namespace covaria
