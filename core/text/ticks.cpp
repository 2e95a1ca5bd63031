// Ticks of axes.
#include "core/text/ticks.h"

#include <algorithm>
#include <cmath>

#include "core/text/numbers.h"
#include "core/text/round_numbers.h"

namespace covaria {
namespace {

/// Numbers from 0.001 to 100 000 are written out.
int exponent_for(double largest, double step) {
    if (largest < 1e5 && (largest >= 0.01 || step >= 1e-3)) return 0;
    return axis_exponent(largest);
}

Ticks one_two_five(double low, double high, const NumberLocale& locale) {
    Ticks result;
    for (int decade = static_cast<int>(std::floor(low)); decade <= high; ++decade)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double at = decade + std::log10(factor);
            if (at < low - 1e-9 || at > high + 1e-9) continue;
            result.ticks.push_back(
                {at, grouped_number(factor * std::pow(10.0, decade), std::max(0, -decade), locale)});
        }
    return result;
}

Ticks linear_on_logarithmic(double low, double high, int most, const NumberLocale& locale) {
    Ticks result = linear_ticks(std::pow(10.0, low), std::pow(10.0, high), most, locale);
    for (Tick& tick : result.ticks) tick.at = std::log10(tick.at);
    return result;
}

}  // namespace

int axis_exponent(double largest) {
    if (!(largest > 0.0) || !std::isfinite(largest)) return 0;
    return 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
}

Ticks linear_ticks(double low, double high, int most, const NumberLocale& locale,
                   std::optional<int> exponent) {
    Ticks result;
    if (!(high > low)) return result;
    const double step = round_number_above((high - low) / std::max(most, 1));
    result.exponent = exponent.value_or(exponent_for(std::max(std::abs(low), std::abs(high)), step));
    const double unit = std::pow(10.0, result.exponent);
    const int decimals = decimals_of_step(step / unit);
    const double slack = 1e-9 * (high - low);
    for (double i = std::ceil((low - slack) / step); i * step <= high + slack; ++i)
        result.ticks.push_back({i * step, grouped_number(i * step / unit, decimals, locale)});
    return result;
}

Ticks logarithmic_ticks(double low, double high, int most, const NumberLocale& locale) {
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
