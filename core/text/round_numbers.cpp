// Round numbers.
#include "core/text/round_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/numbers.h"

namespace covaria {
namespace {

constexpr std::array<double, 4> steps{1.0, 2.0, 5.0, 10.0};

double decade_below(double value) {
    return std::pow(10.0, std::floor(std::log10(value)));
}

}  // namespace

double nearest_round_number(double value) {
    const double decade = decade_below(value);
    const auto ratio = [&](double step) { return std::abs(std::log(value / (step * decade))); };
    return decade * *std::min_element(steps.begin(), steps.end(),
                                      [&](double a, double b) { return ratio(a) < ratio(b); });
}

double round_number_below(double value) {
    const double decade = decade_below(value);
    double best = decade;
    for (double step : steps)
        if (step * decade <= value * (1 + 1e-9)) best = step * decade;
    return best;
}

double round_number_above(double value) {
    const double decade = decade_below(value);
    for (double step : steps)
        if (step * decade >= value * (1.0 - 1e-9)) return step * decade;
    return 10.0 * decade;
}

double rounded_down(double value, int digits) {
    if (!(value > 0.0)) return value;
    const double step = std::pow(10.0, std::floor(std::log10(value)) - digits + 1);
    return step * std::floor(value / step * (1.0 + 1e-12));  // a multiple stays what it is
}

int decimals_of_step(double step) {
    return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

std::string round_number_text(double value) {
    return grouped_number(value, value > 0.0 ? decimals_of_step(value) : 0);
}

}  // namespace covaria
