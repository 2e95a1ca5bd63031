// Numbers as metrologists write them: U to two significant digits, the value to match (JCGM 100 7.2.6). The
// `format_` functions give plain texts ("-2.3e-05"), which machines read too; `typeset_number` makes them
// what people read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/unit.h"

namespace covaria {

/// Significant digits of uncertainties that people may choose: one or two are usual, more where the result
/// goes into further computations (JCGM 100 7.2.6).
inline constexpr int fewest_digits = 1, most_digits = 6;

/// Rounded to `digits` significant digits, without exponent where 1e-4 <= |x| < 1e7: "0.066", "1 234.5" has
/// no spaces.
std::string format_significant(double value, int digits);
/// Rounded to the given number of decimals (may be negative).
std::string format_decimals(double value, int decimals);
/// The same without a tail of zeros.
std::string format_trimmed(double value, int digits);
/// Decimals that show `uncertainty` to `digits` significant digits.
int decimals_for(double uncertainty, int digits = 2);
/// A part of a limit, with so many decimals; more where a part that exceeds the limit would be written as 1:
/// "1.003".
std::string format_part_of_limit(double part, int decimals);
/// Value rounded to match its uncertainty: "1 174.91" style without spaces.
std::string format_to_match(double value, double uncertainty, int digits = 2);
/// A number of a row, of which `largest` is the largest: all have its power of ten, or none has one where it
/// is of ordinary size. With the decimals that an uncertainty leaves.
std::string format_in_row(double value, int decimals, double largest);
/// Form of all numbers of a column: each as it is, without or with powers of ten.
enum class NumberForm { each, decimals, powers };
/// Form of a column whose numbers have these sizes; `smallest` > 0.
NumberForm form_of_column(double smallest, double largest);
std::string format_significant(double value, int digits, NumberForm form);
/// A value with every digit that was typed ("10.000172"): all where there are at most 13, else (a
/// computed value) seven.
std::string format_typed(double value);
/// The decimals of observations of one quantity: those of the one that was typed with the most, so that 4.990
/// keeps its zero beside 5.012. -1: each is written as it is, for some are computed, or have powers of ten.
int common_decimals(const std::vector<double>& observations);
/// Estimate of an input quantity: rounded to match its uncertainty, but a typed one keeps every digit.
std::string format_estimate(double value, double uncertainty);
/// Degrees of freedom as they are shown, everywhere alike: with one decimal, by which k can be checked to its
/// own two; whole ones, cut off, from 100; infinite from 10 000, where k of a t distribution differs from the
/// normal one by less than 0.03 %.
double shown_degrees_of_freedom(double nu);
std::string format_degrees_of_freedom(double nu);
/// 0 for a length or angle below a femtometre or femtoradian, which is rounding of a computation.
double without_residue(double shown, const Unit& unit);
/// The unit, with a space before it except the degree sign of plane angle (SI Brochure 5.4.3); empty for 1.
std::string unit_after_number(const Unit& unit);
/// Shortest text that reads back to the same double: for CSV.
std::string format_exact(double value);

/// Shortest text that reads back, without exponent where 1e-4 <= |x| < 1e9: for fields.
std::string format_shortest(double value);
/// A value with at most `digits` significant digits, for messages: "0.0123", "1.5e+05".
std::string format_short(double value, int digits = 3);

/// Marks with which numbers are written where the reader lives.
struct NumberLocale {
    std::string decimal = ".";
    std::string group = "\u202f";  ///< between groups of three digits, where there are groups
    bool operator==(const NumberLocale&) const = default;
};

/// A plain number for people: a true minus sign, powers of ten, the locale's decimal sign: "−2.3×10⁻⁵".
std::string typeset_number(std::string plain, const NumberLocale& locale = {});
/// A number for people, rounded to `decimals`, digits in groups of three from 10 000 on.
std::string grouped_number(double value, int decimals, const NumberLocale& locale = {});
/// The digits of a plain number in groups of three on both sides of its point, where there are more than
/// four: "50.000 78"; what stands behind it (a power of ten, a unit) stays there.
std::string grouped_digits(const std::string& plain, const NumberLocale& locale = {});
/// A plain number with the locale's decimal sign, else as it is.
std::string with_decimal_sign(std::string plain, const NumberLocale& locale);
std::string count_text(std::uint64_t count, const NumberLocale& locale = {});   ///< "1 000 000"
std::string percent_text(double probability, const NumberLocale& locale = {});  ///< "95 %", "95.45 %"
/// Probability of conformity or coverage, never 0 % or 100 % by rounding: "95.45 %", "> 99.99 %", "< 0.01 %".
std::string probability_text(double probability, const NumberLocale& locale = {});
/// 10 to that power: "10⁻⁵".
std::string power_of_ten(int exponent);

}  // namespace covaria
