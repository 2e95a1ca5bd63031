// Addressed uniform draws in chunks that the compiler turns into vector code.
#include "core/random/uniforms.h"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "core/random/philox.h"
#include "core/random/uniform_chunks.h"

namespace covaria {
namespace {

/// 52 random bits as the mantissa of a number in [1, 2); both subtraction and addition are exact.
double to_uniform(std::uint32_t low, std::uint32_t high) {
    const std::uint64_t word = (std::uint64_t{high} << 32) | low;
    return (std::bit_cast<double>((word >> 12) | 0x3FF0000000000000u) - 1.0) + 0x1p-53;
}

}  // namespace

namespace detail {

void fill_chunk(const UniformStream& stream, std::uint64_t counter, double* u) {
    alignas(64) std::uint32_t c0[chunk_counters], c1[chunk_counters], c2[chunk_counters], c3[chunk_counters];
    for (std::size_t i = 0; i < chunk_counters; ++i) {
        c0[i] = static_cast<std::uint32_t>(counter + i);
        c1[i] = static_cast<std::uint32_t>((counter + i) >> 32);
        c2[i] = stream.component;
        c3[i] = stream.purpose;
    }
    auto k0 = static_cast<std::uint32_t>(stream.seed);
    auto k1 = static_cast<std::uint32_t>(stream.seed >> 32);
    for (int round = 0; round < philox_rounds; ++round) {
        for (std::size_t i = 0; i < chunk_counters; ++i) {
            const std::uint64_t p0 = std::uint64_t{philox_multiplier_0} * c0[i];
            const std::uint64_t p1 = std::uint64_t{philox_multiplier_1} * c2[i];
            c0[i] = static_cast<std::uint32_t>(p1 >> 32) ^ c1[i] ^ k0;
            c1[i] = static_cast<std::uint32_t>(p1);
            c2[i] = static_cast<std::uint32_t>(p0 >> 32) ^ c3[i] ^ k1;
            c3[i] = static_cast<std::uint32_t>(p0);
        }
        k0 += philox_weyl_0;
        k1 += philox_weyl_1;
    }
    for (std::size_t i = 0; i < chunk_counters; ++i) {
        u[2 * i] = to_uniform(c0[i], c1[i]);
        u[2 * i + 1] = to_uniform(c2[i], c3[i]);
    }
}

}  // namespace detail

void uniforms(std::uint64_t seed, DrawPurpose purpose, std::uint32_t component, std::uint64_t first_trial,
              std::span<double> u) {
    using namespace detail;
    const UniformStream stream{seed, component, static_cast<std::uint32_t>(purpose)};
    const auto fill = has_avx512() ? fill_chunk_avx512 : fill_chunk;
    std::uint64_t counter = first_trial / 2;
    std::size_t skip = first_trial % 2;
    alignas(64) double chunk[chunk_trials];
    for (std::size_t done = 0; done < u.size(); counter += chunk_counters) {
        const std::size_t count = std::min(chunk_trials - skip, u.size() - done);
        if (count == chunk_trials) {
            fill(stream, counter, u.data() + done);
        } else {
            fill(stream, counter, chunk);
            std::copy_n(chunk + skip, count, u.data() + done);
        }
        done += count;
        skip = 0;
    }
}

}  // namespace covaria
