#include "core/base/printable.h"

namespace covaria {
namespace {

using Byte = unsigned char;

/// U+2400 and what follows it show the characters U+0000 to U+0020.
std::string picture_of(Byte control) {
    constexpr Byte delete_character = 0x7F, picture_of_delete = 0x21;
    const Byte place = control == delete_character ? picture_of_delete : control;
    return {'\xE2', '\x90', static_cast<char>(0x80 + place)};
}

/// U+0080 to U+009F.
bool is_second_control(std::string_view rest) {
    return rest.size() > 1 && static_cast<Byte>(rest[0]) == 0xC2 && static_cast<Byte>(rest[1]) >= 0x80 &&
           static_cast<Byte>(rest[1]) <= 0x9F;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const Byte c = static_cast<Byte>(text[i]);
        if (is_second_control(text.substr(i))) {
            shown += "\uFFFD";
            ++i;
        } else if (c == '\r' && i + 1 < text.size() && text[i + 1] == '\n') {
            continue;
        } else if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7F) {
            shown += picture_of(c);
        } else {
            shown += text[i];
        }
    }
    return shown;
}

}  // namespace covaria
