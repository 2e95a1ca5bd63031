// A name over its unit.
#include "core/text/head_with_unit.h"

#include <array>
#include <string_view>

#include "core/text/numbers.h"

namespace covaria {
namespace {

/// Whether a name would be read wrongly beside a stroke: "value + U / mm". In parentheses ("u(a + b)") it is
/// one thing.
bool is_sum(const Text& name) {
    static constexpr std::array<std::string_view, 3> signs{" + ", " − ", " ± "};
    const std::string letters = name.letters();
    int depth = 0;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        if (letters[i] == '(') ++depth;
        if (letters[i] == ')') --depth;
        for (const std::string_view sign : signs)
            if (depth == 0 && std::string_view(letters).substr(i).starts_with(sign)) return true;
    }
    return false;
}

bool is_compound(std::string_view unit) {
    for (const std::string_view sign : {"/", "·", " "})
        if (unit.find(sign) != std::string_view::npos) return true;
    return false;
}

std::string multiplied(const std::string& unit, int exponent) {
    if (exponent == 0) return unit;
    const std::string power = power_of_ten(exponent);
    if (unit.empty()) return power;
    return unit.starts_with("1/") ? power + unit.substr(1) : power + " " + unit;
}

}  // namespace

Text head_with_unit(const Text& name, const Unit& unit) {
    return head_with_unit(name, unit == Unit{} ? std::string() : unit.display());
}

Text head_with_unit(const Text& name, const std::string& shown_unit, int exponent) {
    const std::string unit = multiplied(shown_unit, exponent);
    if (unit.empty()) return name;
    const std::string divisor = is_compound(unit) ? "(" + unit + ")" : unit;
    if (name.empty()) return divisor;
    return (is_sum(name) ? "(" + name + ")" : name) + (" / " + divisor);
}

}  // namespace covaria
