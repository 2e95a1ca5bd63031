// Rows of numbers for one block of trials: structure of arrays, 64-byte aligned.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>
#include <xsimd/memory/xsimd_aligned_allocator.hpp>

namespace covaria::detail {

/// Trials of a block. Part of the results' reproducibility: sums are made block by block. A multiple of 8
/// (lanes of vector code), and not a power of two, which would map all rows to the same cache sets.
inline constexpr std::size_t block_trials = 1000;
/// Trials that one thread takes at once and that are merged in order as one.
inline constexpr std::uint64_t unit_trials = 10'000;

inline constexpr std::size_t padded_to_lanes(std::size_t trials) {
    return (trials + 7) / 8 * 8;
}

class TrialRows {
public:
    explicit TrialRows(std::size_t rows) : numbers_(std::max<std::size_t>(rows, 1) * block_trials) {}
    double* row(std::size_t i) { return numbers_.data() + i * block_trials; }
    const double* row(std::size_t i) const { return numbers_.data() + i * block_trials; }
    double* data() { return numbers_.data(); }
    const double* data() const { return numbers_.data(); }

private:
    std::vector<double, xsimd::aligned_allocator<double, 64>> numbers_;
};

}  // namespace covaria::detail
