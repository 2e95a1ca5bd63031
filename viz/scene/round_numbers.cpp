// Round numbers and their texts.
#include "viz/scene/round_numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace covaria {
namespace {

constexpr std::array<double, 4> steps{1.0, 2.0, 5.0, 10.0};

double decade_below(double value) {
    return std::pow(10.0, std::floor(std::log10(value)));
}

std::string fixed(double value, int decimals) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed,
                                   std::max(0, decimals));
    return end.ec == std::errc{} ? std::string(text.data(), end.ptr) : "?";
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

std::string plain_number(double value, int decimals) {
    std::string text = fixed(std::abs(value), decimals);
    const bool zero = text.find_first_not_of("0.") == std::string::npos;
    const std::size_t whole = std::min(text.find('.'), text.size());
    if (whole >= 5)
        for (std::size_t i = whole - 3; i > 0 && i<whole; i = i> 3 ? i - 3 : 0) text.insert(i, "\u2009");
    return (value < 0 && !zero ? "\u2212" : "") + text;
}

std::string round_number_text(double value) {
    const int decimals =
        value >= 1 || value <= 0 ? 0 : static_cast<int>(std::ceil(-std::log10(value) - 1e-9));
    return plain_number(value, decimals);
}

std::string percent_text(double probability) {
    for (int decimals = 0; decimals < 3; ++decimals) {
        const double percent = 100 * probability;
        const double scale = std::pow(10.0, decimals);
        if (std::abs(percent * scale - std::round(percent * scale)) < 1e-6)
            return plain_number(percent, decimals) + " %";
    }
    return plain_number(100 * probability, 3) + " %";
}

}  // namespace covaria
