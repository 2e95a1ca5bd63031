// Uniform draws of consecutive counters of Philox, chunk by chunk: for any processor, and eight counters at
// once with AVX-512.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/processor.h"

namespace covaria::detail {

struct UniformStream {
    std::uint64_t seed;
    std::uint32_t component;
    std::uint32_t purpose;
};

inline constexpr std::size_t chunk_counters = 64;  // one chunk stays in the first-level cache
inline constexpr std::size_t chunk_trials = 2 * chunk_counters;

/// Makes all draws of `chunk_counters` consecutive counters.
void fill_chunk(const UniformStream& stream, std::uint64_t counter, double* u);
/// Makes the same bits; needs has_avx512().
COVARIA_AVX512 void fill_chunk_avx512(const UniformStream& stream, std::uint64_t counter, double* u);

}  // namespace covaria::detail
