// Parsing and showing of units of measurement.
#include "core/base/unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/base/unit_table.h"

namespace covaria {

namespace {

constexpr std::size_t longest_text = 64;

/// One factor of a product of units.
struct Factor {
    const detail::UnitEntry* unit = nullptr;
    int exponent = 1;      ///< as written, before the sign of a quotient
    bool divides = false;  ///< stands after '/'
};

tl::unexpected<Error> malformed(std::string_view text, std::string_view what) {
    return fail(ErrorCode::bad_input, "unit \"" + std::string(text) + "\": " + std::string(what));
}

/// Signs people type, in the plain letters the parser reads. "°C" needs no entry: "deg" + "C".
constexpr std::array<std::pair<std::string_view, std::string_view>, 22> signs{
    {{"\u00B5", "u"},      {"\u03BC", "u"},      {"\u03A9", "ohm"},  {"\u2126", "ohm"}, {"\u00B0", "deg"},
     {"\u2032", "arcmin"}, {"\u2033", "arcsec"}, {"\u2103", "degC"}, {"\u00B7", "*"},   {"\u22C5", "*"},
     {"\u00D7", "*"},      {"\u2212", "-"},      {"\u207B", "-"},    {"\u00B9", "1"},   {"\u00B2", "2"},
     {"\u00B3", "3"},      {"\u2074", "4"},      {"\u2075", "5"},    {"\u2076", "6"},   {"\u2077", "7"},
     {"\u2078", "8"},      {"\u2079", "9"}}};

std::string plain_letters(std::string_view text) {
    std::string plain;
    while (!text.empty()) {
        bool replaced = false;
        for (const auto& [sign, letters] : signs) {
            if (!text.starts_with(sign)) continue;
            plain += letters;
            text.remove_prefix(sign.size());
            replaced = true;
            break;
        }
        if (replaced) continue;
        plain += text.front();
        text.remove_prefix(1);
    }
    return plain;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Splits "s^-2" or "s2" into name and exponent; false if the exponent is malformed.
bool split_power(std::string_view word, std::string_view& name, int& exponent) {
    exponent = 1;
    std::size_t end = word.find('^');
    std::string_view digits;
    if (end != std::string_view::npos) {
        digits = word.substr(end + 1);
    } else {
        end = word.size();
        while (end > 0 && is_digit(word[end - 1])) --end;
        if (end > 0 && word[end - 1] == '-') --end;
        digits = word.substr(end);
    }
    if (end == 0) {  // a pure number: only "1" is a unit, the table says so
        name = word;
        return true;
    }
    name = word.substr(0, end);
    if (digits.empty()) return word.size() == end;
    const bool negative = digits.front() == '-';
    if (negative) digits.remove_prefix(1);
    if (digits.size() != 1 || !is_digit(digits.front()) || digits.front() == '0') return false;
    exponent = (digits.front() - '0') * (negative ? -1 : 1);
    return true;
}

Result<Factor> parse_factor(std::string_view word, std::string_view whole) {
    if (word.empty()) return malformed(whole, "a unit is missing beside '*' or '/'.");
    if (word.find(' ') != std::string_view::npos)
        return malformed(whole, "write a product with '*' (\"N*m\"), not with a blank.");
    std::string_view name;
    Factor factor;
    if (!split_power(word, name, factor.exponent))
        return malformed(whole, "the exponent must be a whole number between -9 and 9, not 0 (\"mm^2\").");
    factor.unit = detail::find_unit(name);
    if (factor.unit != nullptr) return factor;
    if (is_digit(name.front()))
        return malformed(whole, "numbers other than 1 do not belong in a unit; put them into the value.");
    return malformed(whole,
                     "the unit \"" + std::string(name) + "\" is not known." + detail::unit_suggestion(name));
}

Result<std::vector<Factor>> parse_factors(std::string_view plain, std::string_view whole) {
    std::vector<Factor> factors;
    bool divides = false;
    for (std::size_t begin = 0; begin <= plain.size();) {
        const std::size_t end = std::min(plain.find_first_of("*/", begin), plain.size());
        Result<Factor> factor = parse_factor(trimmed(plain.substr(begin, end - begin)), whole);
        if (!factor) return fail(std::move(factor.error()));
        factor->divides = divides;
        factors.push_back(*factor);
        divides = end < plain.size() && plain[end] == '/';
        begin = end + 1;
    }
    return factors;
}

std::string canonical_text(const std::vector<Factor>& factors) {
    std::string text;
    for (const Factor& f : factors) {
        if (!text.empty()) text += f.divides ? '/' : '*';
        text += f.unit->name;
        if (f.exponent != 1) text += "^" + std::to_string(f.exponent);
    }
    return text;
}

std::string superscript(int exponent) {
    static constexpr std::array<std::string_view, 10> digits{
        "\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074", "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    return std::string(exponent < 0 ? "\u207B" : "") +
           std::string(digits[static_cast<std::size_t>(std::abs(exponent))]);
}

}  // namespace

Result<Unit> Unit::parse(std::string_view text) {
    if (text.size() > longest_text)
        return malformed(text.substr(0, longest_text), "the text is too long for a unit.");
    const std::string plain = plain_letters(text);
    if (trimmed(plain).empty())
        return fail(ErrorCode::bad_input, "the unit is empty: write \"1\" for a pure number.");
    const Result<std::vector<Factor>> factors = parse_factors(plain, text);
    if (!factors) return fail(factors.error());
    Unit unit;
    unit.text_ = canonical_text(*factors);
    std::array<int, 8> exponents{};
    for (const Factor& f : *factors) {
        const int power = f.divides ? -f.exponent : f.exponent;
        const double up = power > 0 ? f.unit->numerator : f.unit->denominator;
        const double down = power > 0 ? f.unit->denominator : f.unit->numerator;
        unit.numerator_ *= std::pow(up, std::abs(power));
        unit.denominator_ *= std::pow(down, std::abs(power));
        for (std::size_t i = 0; i < exponents.size(); ++i)
            exponents[i] += power * f.unit->dimension.exponents[i];
    }
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        if (std::abs(exponents[i]) > 127) return malformed(text, "the exponents are too large.");
        unit.dimension_.exponents[i] = static_cast<std::int8_t>(exponents[i]);
    }
    if (!std::isfinite(unit.numerator_) || !std::isfinite(unit.denominator_))
        return malformed(text, "the exponents are too large.");
    // Only the scale itself has a zero of its own; in compounds degC stands for an interval.
    if (factors->size() == 1 && factors->front().exponent == 1) unit.offset_ = factors->front().unit->offset;
    return unit;
}

Unit Unit::of(std::string_view text) {
    Result<Unit> unit = parse(text);
    if (unit) return *std::move(unit);
    std::fputs((unit.error().message + "\n").c_str(), stderr);
    std::abort();
}

std::string Unit::display() const {
    const Result<std::vector<Factor>> factors = parse_factors(text_, text_);
    if (!factors) return text_;
    std::string shown;
    for (const Factor& f : *factors) {
        if (!shown.empty()) shown += f.divides ? "/" : "·";
        shown += f.unit->display;
        if (f.exponent != 1) shown += superscript(f.exponent);
    }
    return shown;
}

}  // namespace covaria
