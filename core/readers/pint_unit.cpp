#include "core/readers/pint_unit.h"

#include <array>
#include <cctype>
#include <map>
#include <utility>

#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

const std::map<std::string, std::string>& pint_words() {
    static const std::map<std::string, std::string> words{{"delta_degC", "K"},
                                                          {"delta_degree_Celsius", "K"},
                                                          {"degK", "K"},
                                                          {"degree_Celsius", "degC"},
                                                          {"celsius", "degC"},
                                                          {"dimensionless", "1"},
                                                          {"percent", "%"},
                                                          {"meter", "m"},
                                                          {"metre", "m"},
                                                          {"gram", "g"},
                                                          {"second", "s"},
                                                          {"kelvin", "K"},
                                                          {"ampere", "A"},
                                                          {"volt", "V"},
                                                          {"ohm", "ohm"},
                                                          {"newton", "N"},
                                                          {"pascal", "Pa"},
                                                          {"joule", "J"},
                                                          {"watt", "W"},
                                                          {"hertz", "Hz"},
                                                          {"radian", "rad"},
                                                          {"mole", "mol"},
                                                          {"liter", "L"},
                                                          {"litre", "L"},
                                                          {"farad", "F"},
                                                          {"henry", "H"},
                                                          {"tesla", "T"},
                                                          {"weber", "Wb"},
                                                          {"siemens", "S"},
                                                          {"candela", "cd"},
                                                          {"coulomb", "C"},
                                                          {"degree", "deg"},
                                                          {"arcminute", "arcmin"},
                                                          {"arcsecond", "arcsec"},
                                                          {"inch", "in"},
                                                          {"foot", "ft"},
                                                          {"minute", "min"},
                                                          {"hour", "h"},
                                                          {"pound_force_per_square_inch", "psi"},
                                                          {"pound_force", "lbf"},
                                                          {"force_pound", "lbf"}};
    return words;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> pint_prefixes{{{"tera", "T"},
                                                                                       {"giga", "G"},
                                                                                       {"mega", "M"},
                                                                                       {"kilo", "k"},
                                                                                       {"hecto", "h"},
                                                                                       {"deci", "d"},
                                                                                       {"centi", "c"},
                                                                                       {"milli", "m"},
                                                                                       {"micro", "u"},
                                                                                       {"nano", "n"},
                                                                                       {"pico", "p"},
                                                                                       {"femto", "f"}}};

std::string covaria_word(const std::string& word) {
    const auto& words = pint_words();
    if (const auto found = words.find(word); found != words.end()) return found->second;
    for (const auto& [prefix, letter] : pint_prefixes)
        if (word.starts_with(prefix))
            if (const auto found = words.find(word.substr(prefix.size())); found != words.end())
                return std::string(letter) + found->second;
    return word;
}

}  // namespace

Result<Unit> unit_of_pint(const std::string& text) {
    std::string unit;
    const std::string plain = plain_name(text);
    const auto is_word = [](char c) {
        return std::isalpha(static_cast<unsigned char>(c)) || c == '_' || static_cast<unsigned char>(c) > 127;
    };
    for (std::size_t at = 0; at < plain.size();) {
        if (plain[at] == ' ') {
            ++at;
        } else if (is_word(plain[at])) {
            std::size_t end = at;
            while (end < plain.size() && is_word(plain[end])) ++end;
            const bool product =
                !unit.empty() && unit.back() != '*' && unit.back() != '/' && unit.back() != '(';
            unit += (product ? "*" : "") + covaria_word(plain.substr(at, end - at));
            at = end;
        } else {
            const bool power = plain.compare(at, 2, "**") == 0;
            unit += power ? '^' : plain[at];
            at += power ? 2 : 1;
        }
    }
    return Unit::parse(unit.empty() ? "1" : unit);
}

}  // namespace covaria
