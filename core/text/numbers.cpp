// Rounding of numbers for people (JCGM 100 7.2.6) and their exact text for machines; independent of the
// locale.
#include "core/text/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/base/superscript.h"
#include "core/text/written_out.h"

namespace covaria {
namespace {

constexpr int most_typed_digits = 13;
constexpr double conversion_error = 6e-16;  // relative, of a unit and back
constexpr double tie_width = 1e-14;         // relative, of a number that was computed

/// A tie goes away from zero, in any unit: 1.55 µm is 1.6 µm, and 0.00155 mm, which is a little less in
/// binary, is 0.0016 mm.
double past_tie(double value) {
    return value * (1.0 + tie_width);
}

std::string fixed(double value, int decimals) {
    // 309 digits before the point, and no double has more than 1074 behind it.
    constexpr int most_decimals = 1074;
    std::array<char, 1400> text{};
    decimals = std::clamp(decimals, 0, most_decimals);
    if (tie_width * std::abs(value) < 0.01 * std::pow(10.0, -decimals)) value = past_tie(value);
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

std::string scientific(double value, int decimals) {
    std::array<char, 64> text{};
    if (decimals < most_typed_digits) value = past_tie(value);
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, decimals);
    return {text.data(), end.ptr};
}

std::string not_finite(double value) {
    if (std::isnan(value)) return "–";
    return value > 0.0 ? "∞" : "-∞";
}

/// Decimal exponent of `value` once rounded to `digits`: 9.96 to two digits is 10, so 1.
int rounded_exponent(double value, int digits) {
    const std::string text = scientific(value, digits - 1);
    return std::atoi(text.c_str() + text.find('e') + 1);
}

std::string without_negative_zero(std::string text) {
    const bool zero = text.find_first_of("123456789") == std::string::npos;
    return zero && text.front() == '-' ? text.substr(1) : text;
}

/// Whether a value has few digits, up to the rounding of a conversion of units, so that somebody typed it.
bool is_typed(double value) {
    if (!std::isfinite(value) || value == 0.0) return true;
    const std::string text = scientific(value, most_typed_digits - 1);
    double kept = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), kept);
    return std::abs(kept - value) <= conversion_error * std::abs(value);
}

std::size_t decimals_in(const std::string& text) {
    const std::size_t point = text.find('.');
    return point == std::string::npos ? 0 : std::min(text.find('e'), text.size()) - point - 1;
}

std::string without_trailing_zeros(std::string text) {
    const std::size_t end = std::min(text.find('e'), text.size());
    if (text.find('.') >= end) return text;
    std::size_t kept = text.find_last_not_of('0', end - 1) + 1;
    if (text[kept - 1] == '.') --kept;
    return text.erase(kept, end - kept);
}

/// "e-05" -> "×10⁻⁵".
std::string with_powers(std::string plain) {
    const std::size_t e = plain.find('e');
    const bool power =
        e != std::string::npos && e + 1 < plain.size() && (plain[e + 1] == '-' || plain[e + 1] == '+');
    if (!power) return plain;
    const std::size_t end = std::min(plain.find_first_not_of("0123456789", e + 2), plain.size());
    return plain.replace(e, end - e, "×" + power_of_ten(std::atoi(plain.c_str() + e + 1)));
}

/// Is written without a power of ten.
bool is_ordinary(double size) {
    return size >= smallest_written_out && size < 1e7;
}

}  // namespace

std::string format_decimals(double value, int decimals) {
    if (!std::isfinite(value)) return not_finite(value);
    if (decimals >= 0) return without_negative_zero(fixed(value, decimals));
    const double step = std::pow(10.0, std::min(-decimals, std::numeric_limits<double>::max_exponent10));
    return without_negative_zero(fixed(std::round(past_tie(value) / step) * step, 0));
}

std::string format_significant(double value, int digits) {
    if (!std::isfinite(value)) return not_finite(value);
    if (value == 0.0) return "0";
    const int kept = std::max(digits, 1);
    const double size = std::abs(value);
    if (!is_ordinary(size)) return scientific(value, kept - 1);
    return format_decimals(value, kept - 1 - rounded_exponent(value, kept));
}

std::string format_trimmed(double value, int digits) {
    return without_trailing_zeros(format_significant(value, digits));
}

int decimals_for(double uncertainty, int digits) {
    if (!std::isfinite(uncertainty) || uncertainty == 0.0) return computed_digits - 1;
    return digits - 1 - rounded_exponent(uncertainty, digits);
}

std::string format_part_of_limit(double part, int decimals) {
    constexpr int most_decimals = 15;
    while (part > 1.0 && decimals < most_decimals && part - 1.0 < 0.5 * std::pow(10.0, -decimals)) ++decimals;
    return format_decimals(part, decimals);
}

std::string format_to_match(double value, double uncertainty, int digits) {
    if (!std::isfinite(uncertainty) || uncertainty == 0.0) return format_trimmed(value, computed_digits);
    const int decimals = decimals_for(uncertainty, digits);
    // 50.000838 with u = 8.4e-5 is read more easily than 5.0000838e+01.
    if (std::abs(uncertainty) >= 1e7 ||
        std::max(std::abs(value), std::abs(uncertainty)) < smallest_written_out) {
        if (value == 0.0) return "0";
        const int value_digits = rounded_exponent(value, 1) + decimals + 1;
        return value_digits < 1 ? "0" : scientific(value, value_digits - 1);
    }
    return format_decimals(value, decimals);
}

std::string format_in_row(double value, int decimals, double largest) {
    constexpr int most_decimals = 12;
    // 50 000 838 beside u = 35, as in the result line.
    const bool written_out = is_ordinary(largest) || is_written_out(largest, decimals);
    const bool with_power = std::isfinite(largest) && largest > 0.0 && !written_out;
    if (!std::isfinite(value)) return not_finite(value);
    if (value == 0.0) return with_power ? "0" : format_decimals(value, decimals);
    const int power = with_power ? rounded_exponent(largest, 3) : 0;
    if (decimals + power > most_decimals && !is_ordinary(std::abs(value))) {  // only zeros would be seen
        const int digits = rounded_exponent(value, 1) + decimals + 1;
        return digits < 1 ? "0" : scientific(value, digits - 1);
    }
    if (!with_power) return format_decimals(value, decimals);
    const std::string sign = power < 0 ? "e-" : "e+", size = std::to_string(std::abs(power));
    return format_decimals(value * std::pow(10.0, -power), std::max(0, decimals + power)) + sign +
           (size.size() < 2 ? "0" : "") + size;
}

NumberForm form_of_column(double smallest, double largest) {
    constexpr double least_in_decimals = 1e-7;
    if (is_ordinary(smallest) && is_ordinary(largest)) return NumberForm::each;
    if (!is_ordinary(largest)) return NumberForm::powers;
    // 0.46 is not written as 4.6×10⁻¹ for the sake of a 3×10⁻⁹ below it.
    return smallest >= least_in_decimals ? NumberForm::decimals : NumberForm::each;
}

std::string format_significant(double value, int digits, NumberForm form) {
    if (form == NumberForm::each || !std::isfinite(value) || value == 0.0)
        return format_significant(value, digits);
    const int kept = std::max(digits, 1);
    if (form == NumberForm::powers) return scientific(value, kept - 1);
    return format_decimals(value, kept - 1 - rounded_exponent(value, kept));
}

std::string format_typed(double value) {
    // A large whole number loses no digits: 50000623 nm.
    const double whole = std::round(value), size = std::abs(value);
    if (std::abs(value - whole) <= conversion_error * size && size >= 1e7 && size < 1e12)
        return fixed(whole, 0);
    if (is_typed(value)) return format_trimmed(value, most_typed_digits);
    return format_trimmed(value, computed_digits);
}

int common_decimals(const std::vector<double>& observations) {
    int most = 0;
    double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
    bool has_powers = false;
    for (const double value : observations) {
        if (!std::isfinite(value) || !is_typed(value)) return -1;
        const std::string typed = format_typed(value);
        const std::size_t e = typed.find('e');
        const int power = e == std::string::npos ? 0 : std::atoi(typed.c_str() + e + 1);
        has_powers = has_powers || power != 0;
        most = std::max(most, static_cast<int>(decimals_in(typed)) - power);
        if (value != 0.0) smallest = std::min(smallest, std::abs(value));
        largest = std::max(largest, std::abs(value));
    }
    if (observations.empty() || (has_powers && form_of_column(smallest, largest) != NumberForm::decimals))
        return -1;
    return most;
}

std::string format_estimate(double value, double uncertainty) {
    const std::string typed = format_typed(value);
    if (!(uncertainty > 0.0) || !std::isfinite(uncertainty)) return typed;
    const std::string matched = format_to_match(value, uncertainty);
    if (!is_typed(value)) return matched;
    const bool plain = typed.find('e') == std::string::npos && matched.find('e') != std::string::npos;
    return plain || decimals_in(typed) > decimals_in(matched) ? typed : matched;
}

double shown_degrees_of_freedom(double nu) {
    if (std::isnan(nu)) return nu;
    if (nu >= 1e4) return std::numeric_limits<double>::infinity();
    if (nu >= 100.0) return std::floor(nu * (1.0 + 1e-12));
    return nu >= 1.0 ? std::round(10.0 * nu) / 10.0 : std::round(100.0 * nu) / 100.0;
}

std::string format_degrees_of_freedom(double nu) {
    return format_trimmed(shown_degrees_of_freedom(nu), computed_digits);
}

double without_residue(double shown, const Unit& unit) {
    static const Dimension length = Unit::of("m").dimension(), angle = Unit::of("rad").dimension();
    const bool is_measured = unit.dimension() == length || unit.dimension() == angle;
    return is_measured && std::abs(unit.interval_to_si(shown)) < 1e-15 ? 0.0 : shown;
}

std::string unit_after_number(const Unit& unit) {
    if (unit.text() == "1") return {};
    const bool is_sign = unit.text() == "deg" || unit.text() == "arcmin" || unit.text() == "arcsec";
    return (is_sign ? "" : "\u00a0") + unit.display();
}

std::string format_exact(double value) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

std::string format_shortest(double value) {
    const double size = std::abs(value);
    const bool plain = value == 0.0 || (size >= 1e-4 && size < 1e9);
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   plain ? std::chars_format::fixed : std::chars_format::scientific);
    return {text.data(), end.ptr};
}

std::string format_short(double value, int digits) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

std::string typeset_number(std::string plain, const NumberLocale& locale) {
    plain = with_decimal_sign(with_powers(std::move(plain)), locale);
    if (!plain.empty() && plain.front() == '-') plain.replace(0, 1, "−");
    return plain;
}

std::string grouped_number(double value, int decimals, const NumberLocale& locale) {
    return grouped_digits(format_decimals(value, decimals), locale);
}

std::string grouped_digits(const std::string& plain, const NumberLocale& locale) {
    const std::size_t end = std::min(plain.find_first_not_of("-.0123456789"), plain.size());
    const std::size_t first = plain.starts_with('-') ? 1 : 0, point = std::min(plain.find('.'), end);
    if (first == end) return typeset_number(plain, locale);
    std::string whole = plain.substr(first, point - first);
    if (whole.size() > 4)
        for (std::size_t i = whole.size(); i > 3;) whole.insert(i -= 3, locale.group);
    std::string parts = point < end ? plain.substr(point + 1, end - point - 1) : "";
    if (parts.size() > 4)
        for (std::size_t i = (parts.size() - 1) / 3 * 3; i > 0; i -= 3) parts.insert(i, locale.group);
    // The rest has no decimal sign of its own: a power of ten, a unit.
    const std::string behind = with_powers(plain.substr(end));
    return (first ? "−" : "") + whole + (point < end ? locale.decimal + parts : std::string()) + behind;
}

std::string with_decimal_sign(std::string plain, const NumberLocale& locale) {
    if (const std::size_t point = plain.find('.'); point != std::string::npos)
        plain.replace(point, 1, locale.decimal);
    return plain;
}

std::string count_text(std::uint64_t count, const NumberLocale& locale) {
    return grouped_number(static_cast<double>(count), 0, locale);
}

std::string percent_text(double probability, const NumberLocale& locale) {
    return typeset_number(format_typed(100.0 * probability), locale) + "\u00a0%";
}

std::string probability_text(double probability, const NumberLocale& locale) {
    constexpr double least = 1e-4, most = 1.0 - least;  // written out
    const auto percent = [&](double p) {
        return grouped_digits(format_trimmed(100.0 * p, 4), locale) + "\u00a0%";
    };
    if (probability > 0.0 && probability < least) return "< " + percent(least);
    if (probability > most && probability < 1.0) return "> " + percent(most);
    return percent(probability);
}

std::string power_of_ten(int exponent) {
    return "10" + superscript(exponent);
}

}  // namespace covaria
