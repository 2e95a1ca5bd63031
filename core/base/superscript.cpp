#include "core/base/superscript.h"

#include <array>

namespace covaria {

std::string superscript(int exponent) {
    static constexpr std::array<const char*, 10> figures{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string above;
    for (const char c : std::to_string(exponent))
        above += c == '-' ? "⁻" : figures[static_cast<std::size_t>(c - '0')];
    return above;
}

}  // namespace covaria
