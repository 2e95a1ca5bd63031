// Ticks of axes.
#include "core/text/ticks.h"

#include <algorithm>
#include <cmath>

#include "core/text/numbers.h"
#include "core/text/round_numbers.h"

namespace covaria {
namespace {

constexpr int smallest_exponent = -306;      // ten to it is a number with all its digits
constexpr double largest_logarithm = 400.0;  // no number has a larger one

/// Numbers from 0.001 to 100 000 are written out.
int exponent_for(double largest, double step) {
    if (largest < 1e5 && (largest >= 0.01 || step >= 1e-3)) return 0;
    return axis_exponent(largest);
}

/// 0.005, 20 000; 2×10⁻⁹ where zeros would have to be counted.
std::string text_in_decade(double factor, int decade, const NumberLocale& locale) {
    constexpr int smallest_written = -6, largest_written = 8;
    if (decade < smallest_written || decade > largest_written)
        return grouped_number(factor, 0, locale) + "×" + power_of_ten(decade);
    return grouped_number(factor * std::pow(10.0, decade), std::max(0, -decade), locale);
}

Ticks one_two_five(double low, double high, const NumberLocale& locale) {
    Ticks result;
    for (int decade = static_cast<int>(std::floor(low)); decade <= high; ++decade)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double at = decade + std::log10(factor);
            if (at < low - 1e-9 || at > high + 1e-9) continue;
            result.ticks.push_back({at, text_in_decade(factor, decade, locale)});
        }
    return result;
}

Ticks linear_on_logarithmic(double low, double high, int most, const NumberLocale& locale) {
    Ticks result = linear_ticks(std::pow(10.0, low), std::pow(10.0, high), most, locale);
    for (Tick& tick : result.ticks) tick.at = std::log10(tick.at);
    std::erase_if(result.ticks, [](const Tick& tick) { return !std::isfinite(tick.at); });
    return result;
}

}  // namespace

int axis_exponent(double largest) {
    if (!(largest > 0.0) || !std::isfinite(largest)) return 0;
    return std::max(smallest_exponent, 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0)));
}

Ticks linear_ticks(double low, double high, int most, const NumberLocale& locale,
                   std::optional<int> exponent) {
    Ticks result;
    if (!(high > low) || !std::isfinite(low) || !std::isfinite(high)) return result;
    const double largest = std::max(std::abs(low), std::abs(high)), parts = std::max(most, 1);
    // Steps of less are lost in the rounding of what is written.
    const double smallest = 4.0 * resolution_at(largest);
    const double step = round_number_above(std::max(high / parts - low / parts, smallest));
    result.exponent = exponent.value_or(exponent_for(largest, step));
    const double unit = std::pow(10.0, result.exponent);
    const int decimals = decimals_of_step(step / unit);
    for (const double at : multiples_between(low, high, step, static_cast<std::size_t>(parts) + 1))
        result.ticks.push_back({at, grouped_number(at / unit, decimals, locale)});
    return result;
}

Ticks logarithmic_ticks(double low, double high, int most, const NumberLocale& locale) {
    if (!(high > low) || !(low >= -largest_logarithm) || !(high <= largest_logarithm)) return {};
    const int first = static_cast<int>(std::ceil(low - 1e-9)),
              last = static_cast<int>(std::floor(high + 1e-9));
    if (last - first >= 1) {
        Ticks result;
        const int step = std::max(1, static_cast<int>(std::ceil((last - first) / double(std::max(most, 1)))));
        for (int decade = first; decade <= last; decade += step)
            result.ticks.push_back({double(decade), power_of_ten(decade)});
        return result;
    }
    Ticks fine = one_two_five(low, high, locale);
    const bool enough = fine.ticks.size() >= 2 && static_cast<int>(fine.ticks.size()) <= most + 1;
    return enough ? fine : linear_on_logarithmic(low, high, most, locale);
}

}  // namespace covaria
