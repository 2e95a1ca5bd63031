#include "core/views/result_statement.h"

#include <algorithm>
#include <cmath>

#include "core/math/special_quantiles.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/text/written_out.h"
#include "core/views/statement_words.h"

namespace covaria {
namespace {

constexpr double skewed_from = 0.05;           // as a part of U
constexpr double unnoticed_difference = 0.05;  // as a part of u, between the two methods
constexpr double largest_stated = 0.999;       // largest probability that is stated: none is rounded to 100 %

/// The way to write the numbers of one result: all of them multiplied by a power of ten, to one place.
struct Place {
    int exponent = 0, decimals = 0;
    NumberLocale locale = {};

    std::string operator()(double value) const {
        return grouped_digits(format_decimals(value * std::pow(10.0, -exponent), decimals), locale);
    }
};

/// The place of the numbers of a result. Two digits of U cannot lose 5 % of it by rounding, so nothing is
/// rounded up (ILAC-P14 5.4). `largest` is the largest number, the limits of the interval among them.
Place place_for(double estimate, double uncertainty, double largest, int digits, const NumberLocale& locale) {
    const int decimals = decimals_for(uncertainty, digits);
    if (is_written_out(largest, decimals)) return {0, decimals, locale};
    const int exponent = -decimals_for(std::max(std::abs(estimate), uncertainty), 1);
    return {exponent, decimals + exponent, locale};
}

Place place_for(const OutputResult& output, const UncertaintyResult& result, const Unit& unit, int digits,
                const NumberLocale& locale) {
    return place_for(unit.from_si(output.estimate), unit.interval_from_si(stated_spread(output, result)),
                     largest_stated_number(output, result, unit), digits, locale);
}

bool has_interval(double estimate, double uncertainty) {
    return std::isfinite(estimate) && std::isfinite(uncertainty) && uncertainty > 0.0;
}

/// Whether the interval by Monte Carlo of a result line with U > 0 is not symmetric about the estimate.
bool is_skewed(const OutputResult& output, const UncertaintyResult& result) {
    const double y = output.estimate, U = output.expanded_uncertainty;
    if (!output.monte_carlo || !has_interval(y, U)) return false;
    const CoverageInterval interval = coverage_interval_of(output, result);
    return !(std::abs(0.5 * (interval.low + interval.high) - y) <= skewed_from * U);
}

std::string power_words(int exponent) {
    return exponent == 0 ? "" : "×" + power_of_ten(exponent);
}

}  // namespace

std::string value_statement(const OutputResult& output, bool with_unit, const DocumentLanguage& in,
                            const DisplayUnits& units, int digits) {
    return value_statement(output.estimate, output.expanded_uncertainty, units.of(output.quantity.unit),
                           digits, with_unit, in);
}

std::string value_statement(double estimate, double uncertainty, const Unit& unit, int digits, bool with_unit,
                            const DocumentLanguage& in) {
    const double y = unit.from_si(estimate), U = unit.interval_from_si(uncertainty);
    const std::string in_unit = with_unit ? unit_after_number(unit) : "";
    if (!has_interval(y, U))
        return in.say(U == 0.0 ? statement_words::exact : statement_words::not_finite,
                      {grouped_digits(format_typed(y), in.numbers()) + in_unit});
    const Place place = place_for(y, U, std::abs(y) + U, digits, in.numbers());
    const std::string pair = place(y) + " ± " + place(U), power = power_words(place.exponent);
    return in_unit.empty() && power.empty() ? pair : "(" + pair + ")" + power + in_unit;
}

std::string result_statement(const OutputResult& output, const UncertaintyResult& result,
                             const DocumentLanguage& in, const DisplayUnits& units, int digits) {
    if (!is_stated_by_interval(output, result)) {
        const std::string value = value_statement(output, true, in, units, digits);
        return output.expanded_uncertainty == 0.0
                   ? value
                   : value + ", " + coverage_statement(output, result, in, units, digits);
    }
    const Unit& unit = units.of(output.quantity.unit);
    const double y = unit.from_si(output.estimate);
    const double u = unit.interval_from_si(output.standard_uncertainty);
    const Place place = place_for(output, result, unit, digits, in.numbers());
    const std::string behind = power_words(place.exponent) + unit_after_number(unit);
    std::string words = place(y) + behind;
    if (std::isfinite(u)) words += ", u = " + place(u) + behind;
    return words + ", p = " + probability_text(stated_probability(output, result), in) + ", " +
           in.say(statement_words::coverage_interval, {skewed_interval(output, result, in, units, digits)});
}

double largest_stated_number(const OutputResult& output, const UncertaintyResult& result, const Unit& unit) {
    const CoverageInterval interval = coverage_interval_of(output, result);
    double largest = 0.0;
    for (const double size :
         {std::abs(unit.from_si(output.estimate)), unit.interval_from_si(stated_spread(output, result)),
          std::abs(unit.from_si(interval.low)), std::abs(unit.from_si(interval.high))})
        if (std::isfinite(size)) largest = std::max(largest, size);
    return largest;
}

bool is_stated_by_interval(const OutputResult& output, const UncertaintyResult& result) {
    return expanded_by(result) != ExpandedBy::fixed_factor && is_skewed(output, result);
}

std::optional<double> part_of_first_order(const OutputResult& output) {
    const double part = output.first_order.standard_uncertainty / output.standard_uncertainty;
    if (!std::isfinite(part) || std::abs(part - 1.0) <= unnoticed_difference) return std::nullopt;
    return 0.01 * std::round(100.0 * part);
}

double stated_spread(const OutputResult& output, const UncertaintyResult& result) {
    const double u = output.standard_uncertainty;
    const bool by_u = is_stated_by_interval(output, result) && std::isfinite(u) && u > 0.0;
    // With tails that are so long u says little of the interval.
    return by_u ? std::min(u, output.expanded_uncertainty) : output.expanded_uncertainty;
}

double stated_probability(const OutputResult& output, const UncertaintyResult& result) {
    if (expanded_by(result) != ExpandedBy::fixed_factor) return result.coverage_probability;
    const double y = output.estimate, U = output.expanded_uncertainty;
    // More decimals than the trials support would be noise.
    if (output.monte_carlo)
        return std::min(1e-3 * std::round(1e3 * output.monte_carlo->distribution.inside(y - U, y + U)),
                        largest_stated);
    return stated_probability(output.first_order, result);
}

double stated_probability(const FirstOrderOutput& first, const UncertaintyResult& result) {
    if (expanded_by(result) != ExpandedBy::fixed_factor) return result.coverage_probability;
    return std::min(
        1.0 - 2.0 * t_distribution_function(-first.coverage_factor, first.effective_degrees_of_freedom),
        largest_stated);
}

std::string probability_text(double probability, const DocumentLanguage& in) {
    return probability_text(probability, in.numbers());
}

double stated_degrees_of_freedom(const OutputResult& output, const UncertaintyResult& result) {
    if (expanded_by(result) != ExpandedBy::degrees_of_freedom) return infinity;
    return shown_degrees_of_freedom(output.first_order.effective_degrees_of_freedom);
}

std::string coverage_statement(const OutputResult& output, const UncertaintyResult& result,
                               const DocumentLanguage& in, const DisplayUnits& units, int digits) {
    const double nu = stated_degrees_of_freedom(output, result);
    std::string words =
        std::isfinite(output.coverage_factor)
            ? "k = " + grouped_digits(format_decimals(output.coverage_factor, 2), in.numbers())
            : in.say(statement_words::without_k);
    if (std::isfinite(nu))
        words += ", nu_eff = " + grouped_digits(format_degrees_of_freedom(nu), in.numbers());
    words += ", p = " + probability_text(stated_probability(output, result), in);
    const std::string interval = skewed_interval(output, result, in, units, digits);
    return interval.empty() ? words : words + ", " + in.say(statement_words::coverage_interval, {interval});
}

std::string skewed_interval(const OutputResult& output, const UncertaintyResult& result,
                            const DocumentLanguage& in, const DisplayUnits& units, int digits) {
    if (!is_skewed(output, result)) return {};
    const Unit& unit = units.of(output.quantity.unit);
    const CoverageInterval interval = coverage_interval_of(output, result);
    const double low = unit.from_si(interval.low), high = unit.from_si(interval.high);
    const Place place = place_for(output, result, unit, digits, in.numbers());
    const char* between = in.numbers().decimal == "," ? "; " : ", ";
    return "[" + place(low) + between + place(high) + "]" + power_words(place.exponent) +
           unit_after_number(unit);
}

}  // namespace covaria
