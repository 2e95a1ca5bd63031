// Parsing and showing of units of measurement.
#include "core/base/unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/superscript.h"
#include "core/base/unit_table.h"

namespace covaria {

namespace {

constexpr std::size_t longest_text = 64;
constexpr int largest_exponent = 127;

/// A factor of a product of units.
struct Factor {
    detail::KnownUnit unit;
    int exponent = 1;      ///< exponent as written, before the sign of a quotient
    bool divides = false;  ///< stands after '/'
};
using Factors = std::vector<Factor>;

tl::unexpected<Error> malformed(std::string_view text, Message what) {
    return fail(ErrorCode::bad_input, tell<"unit \"%1\": %2">(text, std::move(what)));
}

/// Signs people type, in the plain letters the parser reads. "°C" needs no entry: "deg" + "C".
constexpr std::array<std::pair<std::string_view, std::string_view>, 23> signs{
    {{"\u00B5", "u"},      {"\u03BC", "u"},      {"\u03A9", "ohm"},  {"\u2126", "ohm"}, {"\u00B0", "deg"},
     {"\u2032", "arcmin"}, {"\u2033", "arcsec"}, {"\u2103", "degC"}, {"\u00B7", "*"},   {"\u22C5", "*"},
     {"\u00D7", "*"},      {"\u2212", "-"},      {"\u207B", "-"},    {"\u00B9", "1"},   {"\u00B2", "2"},
     {"\u2109", "degF"},   {"\u00B3", "3"},      {"\u2074", "4"},    {"\u2075", "5"},   {"\u2076", "6"},
     {"\u2077", "7"},      {"\u2078", "8"},      {"\u2079", "9"}}};

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

/// Reads products, quotients, powers and parentheses; the text is short, so recursion is shallow.
class UnitReader {
public:
    UnitReader(std::string_view plain, std::string_view whole) : rest_(plain), whole_(whole) {}

    Result<Factors> read() {
        Result<Factors> factors = product(false);
        if (factors && !rest_.empty())
            return malformed(whole_, tell<"a parenthesis is closed that was not opened.">());
        return factors;
    }

private:
    /// Up to the end or to the closing parenthesis.
    Result<Factors> product(bool inside) {
        Factors all;
        bool divides = false;
        while (true) {
            Result<Factors> next = power();
            if (!next) return next;
            for (Factor& f : *next) {
                f.divides = f.divides != divides;
                all.push_back(std::move(f));
            }
            const bool blank = take_blanks();
            if (rest_.empty() || rest_.front() == ')') return all;
            if (rest_.front() == '*' || rest_.front() == '/') {
                divides = rest_.front() == '/';
                rest_.remove_prefix(1);
            } else if (!blank || !inside || divides) {  // "m s^-2" may be meant as milliseconds
                return malformed(
                    whole_, tell<"write a product with '*' (\"N*m\", \"W/(m*K)\"), not with a blank.">());
            }
        }
    }

    /// A unit or a product in parentheses, with its exponent.
    Result<Factors> power() {
        take_blanks();
        Factors base;
        if (rest_.starts_with('(')) {
            rest_.remove_prefix(1);
            Result<Factors> inside = product(true);
            if (!inside) return inside;
            if (rest_.empty()) return malformed(whole_, tell<"a parenthesis is not closed.">());
            rest_.remove_prefix(1);
            base = *std::move(inside);
        } else {
            Result<Factor> unit = name();
            if (!unit) return fail(std::move(unit.error()));
            base.push_back(*std::move(unit));
        }
        int exponent = 1;
        if (!take_exponent(exponent))
            return malformed(
                whole_, tell<"the exponent must be a whole number between -9 and 9, not 0 (\"mm^2\").">());
        for (Factor& f : base) {
            f.exponent *= exponent;
            if (std::abs(f.exponent) > largest_exponent)
                return malformed(whole_, tell<"the exponents are too large.">());
        }
        return base;
    }

    Result<Factor> name() {
        if (rest_.empty() || rest_.front() == '*' || rest_.front() == '/' || rest_.front() == ')')
            return malformed(whole_, tell<"a unit is missing beside '*', '/' or a parenthesis.">());
        const std::size_t end = is_digit(rest_.front()) ? rest_.find_first_not_of("0123456789.")
                                                        : rest_.find_first_of("*/^() -0123456789");
        const std::string_view word = rest_.substr(0, end);
        std::optional<detail::KnownUnit> unit = detail::find_unit(word);
        if (!unit && is_digit(rest_.front()))
            return malformed(
                whole_, tell<"numbers other than 1 do not belong in a unit; put them into the value.">());
        if (!unit)
            return malformed(whole_,
                             tell<"the unit \"%1\" is not known.%2">(word, detail::unit_suggestion(word)));
        rest_.remove_prefix(word.size());
        return Factor{*std::move(unit)};
    }

    /// "^-2", "-2" or "2", where there is one; false if it is malformed.
    bool take_exponent(int& exponent) {
        const bool marked = rest_.starts_with('^');
        std::string_view digits = rest_.substr(marked ? 1 : 0);
        const bool negative = digits.starts_with('-');
        if (negative) digits.remove_prefix(1);
        const std::size_t count = std::min(digits.find_first_not_of("0123456789."), digits.size());
        if (!marked && !negative && count == 0) return true;
        if (count != 1 || digits.front() == '0' || digits.front() == '.') return false;
        exponent = (digits.front() - '0') * (negative ? -1 : 1);
        rest_ = digits.substr(1);
        return true;
    }

    bool take_blanks() {
        const std::size_t before = rest_.size();
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
        return rest_.size() < before;
    }

    std::string_view rest_, whole_;
};

struct Texts {
    std::string file, shown;
};

/// The factors in the numerator, then those in the denominator: equal units are written alike.
Texts texts_of(const Factors& factors) {
    Texts sides[2];
    int counts[2] = {0, 0};
    for (const Factor& f : factors) {
        if (f.unit.name == "1") continue;
        Texts& side = sides[f.divides];
        side.file += (counts[f.divides] > 0 ? "*" : "") + f.unit.name;
        side.shown += (counts[f.divides] > 0 ? "·" : "") + f.unit.display;
        ++counts[f.divides];
        if (f.exponent == 1) continue;
        side.file += "^" + std::to_string(f.exponent);
        side.shown += superscript(f.exponent);
    }
    if (counts[0] == 0) sides[0] = {"1", "1"};
    if (counts[1] == 0) return sides[0];
    const bool several = counts[1] > 1;
    return {sides[0].file + (several ? "/(" + sides[1].file + ")" : "/" + sides[1].file),
            sides[0].shown + (several ? "/(" + sides[1].shown + ")" : "/" + sides[1].shown)};
}

}  // namespace

Result<Unit> Unit::parse(std::string_view text) {
    if (text.size() > longest_text)
        return malformed(text.substr(0, longest_text), tell<"the text is too long for a unit.">());
    const std::string plain = plain_letters(text);
    if (trimmed(plain).empty())
        return fail(ErrorCode::bad_input, tell<"the unit is empty: write \"1\" for a pure number.">());
    const Result<Factors> factors = UnitReader(plain, text).read();
    if (!factors) return fail(factors.error());
    Unit unit;
    Texts texts = texts_of(*factors);
    unit.text_ = std::move(texts.file);
    unit.display_ = std::move(texts.shown);
    std::array<int, 8> exponents{};
    for (const Factor& f : *factors) {
        const int power = f.divides ? -f.exponent : f.exponent;
        const double up = power > 0 ? f.unit.numerator : f.unit.denominator;
        const double down = power > 0 ? f.unit.denominator : f.unit.numerator;
        unit.numerator_ *= std::pow(up, std::abs(power));
        unit.denominator_ *= std::pow(down, std::abs(power));
        for (std::size_t i = 0; i < exponents.size(); ++i)
            exponents[i] += power * f.unit.dimension.exponents[i];
    }
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        if (std::abs(exponents[i]) > largest_exponent)
            return malformed(text, tell<"the exponents are too large.">());
        unit.dimension_.exponents[i] = static_cast<std::int8_t>(exponents[i]);
    }
    if (!std::isnormal(unit.numerator_) || !std::isnormal(unit.denominator_))
        return malformed(text, tell<"the exponents are too large.">());
    // Only the scale itself has a zero of its own; in compounds degC stands for an interval.
    if (factors->size() == 1 && factors->front().exponent == 1) unit.offset_ = factors->front().unit.offset;
    return unit;
}

// A set-up of a thousand points asks ten thousand times for the same few.
Unit Unit::of(std::string_view text) {
    thread_local std::map<std::string, Unit, std::less<>> known;
    if (const auto unit = known.find(text); unit != known.end()) return unit->second;
    const Result<Unit> unit = parse(text);
    if (unit) return known.emplace(text, *unit).first->second;
    std::fputs((unit.error().message.english() + "\n").c_str(), stderr);
    std::abort();
}

Unit Unit::interval() const {
    if (!has_offset()) return *this;
    return of(numerator_ == denominator_ ? "K" : "degR");
}

}  // namespace covaria
