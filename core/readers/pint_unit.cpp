#include "core/readers/pint_unit.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

const std::map<std::string, std::string>& pint_words() {
    static const std::map<std::string, std::string> words{{"delta_degC", "K"},
                                                          {"delta_degree_Celsius", "K"},
                                                          {"delta_celsius", "K"},
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
                                                          {"pound", "lb"},
                                                          {"micron", "um"},
                                                          {"day", "d"},
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

/// Units that Covaria does not have, as multiples of those that it has: NIST SP 811, appendix B; heads of
/// water of 1 kg/L and of mercury of 13.5951 kg/L under standard gravity.
const std::map<std::string, std::pair<const char*, double>>& multiples() {
    static const std::map<std::string, std::pair<const char*, double>> words{
        {"delta_degree_Fahrenheit", {"K", 5.0 / 9.0}},
        {"delta_degF", {"K", 5.0 / 9.0}},
        {"degree_Rankine", {"K", 5.0 / 9.0}},
        {"rankine", {"K", 5.0 / 9.0}},
        {"degR", {"K", 5.0 / 9.0}},
        {"inch_H2O", {"Pa", 249.08891}},
        {"inH2O", {"Pa", 249.08891}},
        {"centimeter_H2O", {"Pa", 98.0665}},
        {"cmH2O", {"Pa", 98.0665}},
        {"inch_Hg", {"Pa", 3386.388640341}},
        {"inHg", {"Pa", 3386.388640341}},
        {"millimeter_Hg", {"Pa", 133.322387415}},
        {"mmHg", {"Pa", 133.322387415}},
        {"torr", {"Pa", 101325.0 / 760.0}},
        {"atmosphere", {"Pa", 101325.0}},
        {"standard_atmosphere", {"Pa", 101325.0}},
        {"atm", {"Pa", 101325.0}},
        {"ounce", {"g", 28.349523125}}};
    return words;
}

bool is_fahrenheit(const std::string& word) {
    return word == "degree_Fahrenheit" || word == "degF" || word == "fahrenheit";
}

std::optional<std::string> known_word(const std::string& word) {
    const auto& words = pint_words();
    if (const auto found = words.find(word); found != words.end()) return found->second;
    for (const auto& [prefix, letter] : pint_prefixes)
        if (word.starts_with(prefix))
            if (const auto found = words.find(word.substr(prefix.size())); found != words.end())
                return std::string(letter) + found->second;
    return std::nullopt;
}

std::string covaria_word(const std::string& word) {
    if (const auto known = known_word(word)) return *known;
    if (word.size() > 3 && word.ends_with('s'))  // a plural such as "kiloohms"
        if (const auto known = known_word(word.substr(0, word.size() - 1))) return *known;
    return word;
}

/// The word at `at`: letters and all that belongs to a name, such as the 2 of "inch_H2O", but not that of
/// "cm2".
std::string word_at(const std::string& text, std::size_t at) {
    const auto is_letter = [&](std::size_t i) {
        return i < text.size() && (std::isalpha(static_cast<unsigned char>(text[i])) || text[i] == '_' ||
                                   static_cast<unsigned char>(text[i]) > 127);
    };
    const auto is_inner = [&](std::size_t i) {
        return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) && is_letter(i + 1);
    };
    std::size_t end = at;
    while (is_letter(end) || (end > at && is_inner(end))) ++end;
    return text.substr(at, end - at);
}

/// The whole number behind "**" or "^"; 1 where there is none.
int power_at(const std::string& text, std::size_t at) {
    at = std::min(text.find_first_not_of(' ', at), text.size());
    const std::size_t sign = text.compare(at, 2, "**") == 0 ? 2 : (text.compare(at, 1, "^") == 0 ? 1 : 0);
    if (sign == 0) return 1;
    at = std::min(text.find_first_not_of(' ', at + sign), text.size());
    int power = 1;
    std::from_chars(text.data() + at, text.data() + text.size(), power);
    return power;
}

}  // namespace

Result<PintUnit> unit_of_pint(const std::string& text) {
    PintUnit read;
    std::string unit;
    const std::string plain = plain_name(text);
    if (is_fahrenheit(plain)) return PintUnit{Unit::of("degC"), 5.0 / 9.0, 32.0};
    for (std::size_t at = 0; at < plain.size();) {
        const std::string word = word_at(plain, at);
        if (plain[at] == ' ') {
            ++at;
        } else if (!word.empty()) {
            at += word.size();
            const bool divides = !unit.empty() && unit.back() == '/';
            const bool product =
                !unit.empty() && unit.back() != '*' && unit.back() != '/' && unit.back() != '(';
            const auto multiple = multiples().find(is_fahrenheit(word) ? "delta_degF" : word);
            if (multiple == multiples().end()) {
                unit += (product ? "*" : "") + covaria_word(word);
                continue;
            }
            if (plain.find('(') != std::string::npos)
                return fail(ErrorCode::bad_input, tell<"unit \"%1\": write it without parentheses">(plain));
            unit += (product ? "*" : "") + std::string(multiple->second.first);
            read.scale *= std::pow(multiple->second.second, (divides ? -1 : 1) * power_at(plain, at));
        } else {
            const bool power = plain.compare(at, 2, "**") == 0;
            unit += power ? '^' : plain[at];
            at += power ? 2 : 1;
        }
    }
    const auto parsed = Unit::parse(unit.empty() ? "1" : unit);
    if (!parsed) return fail(parsed.error());
    if (!std::isnormal(read.scale)) return fail(ErrorCode::bad_input, tell<"the exponents are too large">());
    read.unit = *parsed;
    return read;
}

}  // namespace covaria
