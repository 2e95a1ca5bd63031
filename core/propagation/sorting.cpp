// Distribution into buckets by rank of magnitude, then ordinary sorting of each small bucket.
#include "core/propagation/sorting.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>

namespace covaria::detail {
namespace {

/// Order-preserving integer of a double: the bits, with negative numbers turned over.
std::uint64_t key_of(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return bits ^ (bits >> 63 != 0 ? ~std::uint64_t{0} : std::uint64_t{1} << 63);
}

}  // namespace

void sort_descending(std::vector<double>& values) {
    constexpr std::size_t small = 256;
    if (values.size() < small) return std::sort(values.begin(), values.end(), std::greater<>());
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const std::uint64_t first = key_of(*low);
    const std::uint64_t range = key_of(*high) - first;
    if (range == 0) return;
    // About one bucket per two values, of equal width in the order-preserving integers (so of equal relative
    // width where the numbers span many decades).
    const int shift = std::max(
        0, static_cast<int>(std::bit_width(range)) - static_cast<int>(std::bit_width(values.size())));
    std::vector<std::uint32_t> begin((range >> shift) + 2, 0);
    for (const double x : values) ++begin[((range - (key_of(x) - first)) >> shift) + 1];
    for (std::size_t b = 1; b < begin.size(); ++b) begin[b] += begin[b - 1];
    std::vector<double> sorted(values.size());
    std::vector<std::uint32_t> place = begin;
    for (const double x : values) sorted[place[(range - (key_of(x) - first)) >> shift]++] = x;
    for (std::size_t b = 0; b + 1 < begin.size(); ++b)
        if (begin[b + 1] - begin[b] > 1)
            std::sort(sorted.begin() + begin[b], sorted.begin() + begin[b + 1], std::greater<>());
    values.swap(sorted);
}

}  // namespace covaria::detail
