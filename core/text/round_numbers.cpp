// Round numbers.
#include "core/text/round_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/numbers.h"

namespace covaria {
namespace {

constexpr std::array<double, 4> steps{1.0, 2.0, 5.0, 10.0};

// Below it, powers of ten and their halves have no digits left.
constexpr double smallest_decade = 1e-300;

double decade_below(double value) {
    return std::max(smallest_decade, std::pow(10.0, std::floor(std::log10(value))));
}

}  // namespace

double resolution_at(double value) {
    const double size = std::abs(value);
    return size - std::nextafter(size, -1.0);
}

std::vector<double> multiples_between(double low, double high, double step, std::size_t most) {
    std::vector<double> multiples;
    const double slack = 1e-9 * high - 1e-9 * low;
    const double first = std::ceil((low - slack) / step), last = std::floor((high + slack) / step);
    const double count = last - first + 1.0;
    if (!(step > 0.0) || !std::isfinite(first) || !(count >= 1.0 && count <= static_cast<double>(most)))
        return multiples;
    const auto whole = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < whole; ++i) {
        const double at = (first + static_cast<double>(i)) * step;
        const bool is_another = multiples.empty() || at > multiples.back();
        if (is_another && at >= low - slack && at <= high + slack) multiples.push_back(at);
    }
    return multiples;
}

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
    if (!(step > 0.0) || !std::isfinite(step)) return 0;
    return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

std::string round_number_text(double value) {
    return grouped_number(value, value > 0.0 ? decimals_of_step(value) : 0);
}

}  // namespace covaria
