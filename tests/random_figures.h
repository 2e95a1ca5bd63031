// Figures from the whole range of doubles, for tests that hold for all of them: the same on every machine.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace covaria::test {

class RandomFigures {
public:
    explicit RandomFigures(std::uint64_t seed) : bits_(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits_() % count); }

    /// A figure of any size, evenly over the powers of ten; zero and the extreme doubles among them.
    double any() {
        using Limits = std::numeric_limits<double>;
        constexpr std::array<double, 7> special{
            0.0, Limits::denorm_min(), Limits::min(), Limits::max(), 9'192'631'770, 1.0, 1e300};
        const double size = below(8) == 0 ? special[below(special.size())] : size_between(-320.0, 308.0);
        return below(2) == 0 ? size : -size;
    }
    /// A figure of a size that measurements have.
    double usual() { return (below(2) == 0 ? 1.0 : -1.0) * size_between(-6.0, 6.0); }
    double size_between(double lowest_power, double highest_power) {
        return std::pow(10.0, uniform(lowest_power, highest_power));
    }
    /// The ends of a range: from one double to the next, some of them, or of any width.
    std::pair<double, double> range() {
        const double one = below(2) == 0 ? usual() : any();
        double other = any();
        if (below(2) == 0) {
            other = one;
            const std::size_t steps = 1 + below(below(2) == 0 ? 3 : 300);
            for (std::size_t i = 0; i < steps; ++i)
                other = std::nextafter(other, std::numeric_limits<double>::max());
        }
        return {std::min(one, other), std::max(one, other)};
    }

private:
    std::mt19937_64 bits_;
};

}  // namespace covaria::test
