// Philox4x32-10 with a counter in each 64-bit lane: its four words stand in the lower halves of four vectors,
// where the multiplication finds them, and what is in the upper halves never matters.
#include <immintrin.h>

#include "core/random/philox.h"
#include "core/random/uniform_chunks.h"

namespace covaria::detail {
namespace {

constexpr std::size_t lanes = 8;
constexpr std::size_t side_by_side = 2;  // vectors whose chains of operations overlap

struct WideCounters {
    __m512i c0, c1, c2, c3;
};

COVARIA_AVX512 inline void wide_round(WideCounters& c, __m512i k0, __m512i k1) {
    constexpr int exclusive_or = 0x96;  // ternary logic: exclusive or of all three
    const __m512i p0 = _mm512_mul_epu32(_mm512_set1_epi64(philox_multiplier_0), c.c0);
    const __m512i p1 = _mm512_mul_epu32(_mm512_set1_epi64(philox_multiplier_1), c.c2);
    c.c0 = _mm512_ternarylogic_epi64(_mm512_srli_epi64(p1, 32), c.c1, k0, exclusive_or);
    c.c1 = p1;
    c.c2 = _mm512_ternarylogic_epi64(_mm512_srli_epi64(p0, 32), c.c3, k1, exclusive_or);
    c.c3 = p0;
}

/// 52 bits as the mantissa of a number in [1, 2), as for one draw.
COVARIA_AVX512 inline __m512d wide_uniforms(__m512i low, __m512i high) {
    const __m512i word =
        _mm512_or_si512(_mm512_slli_epi64(high, 32), _mm512_srli_epi64(_mm512_slli_epi64(low, 32), 32));
    const __m512i bits = _mm512_or_si512(_mm512_srli_epi64(word, 12), _mm512_set1_epi64(0x3FF0000000000000));
    return _mm512_add_pd(_mm512_sub_pd(_mm512_castsi512_pd(bits), _mm512_set1_pd(1.0)),
                         _mm512_set1_pd(0x1p-53));
}

}  // namespace

COVARIA_AVX512 void fill_chunk_avx512(const UniformStream& stream, std::uint64_t counter, double* u) {
    const __m512i lower = _mm512_set_epi64(11, 3, 10, 2, 9, 1, 8, 0),
                  upper = _mm512_set_epi64(15, 7, 14, 6, 13, 5, 12, 4);
    const __m512i lane = _mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0);
    for (std::size_t i = 0; i < chunk_counters; i += lanes * side_by_side) {
        WideCounters c[side_by_side];
        for (std::size_t k = 0; k < side_by_side; ++k) {
            const std::uint64_t first_counter = counter + i + lanes * k;
            const __m512i first = _mm512_set1_epi64(static_cast<long long>(first_counter));
            c[k].c0 = _mm512_add_epi64(first, lane);
            c[k].c1 = _mm512_srli_epi64(c[k].c0, 32);
            c[k].c2 = _mm512_set1_epi64(stream.component);
            c[k].c3 = _mm512_set1_epi64(stream.purpose);
        }
        auto k0 = static_cast<std::uint32_t>(stream.seed);
        auto k1 = static_cast<std::uint32_t>(stream.seed >> 32);
        for (int round = 0; round < philox_rounds; ++round) {
            const __m512i wide_k0 = _mm512_set1_epi64(k0), wide_k1 = _mm512_set1_epi64(k1);
            for (WideCounters& counters : c) wide_round(counters, wide_k0, wide_k1);
            k0 += philox_weyl_0;
            k1 += philox_weyl_1;
        }
        for (std::size_t k = 0; k < side_by_side; ++k) {
            const __m512d even = wide_uniforms(c[k].c0, c[k].c1), odd = wide_uniforms(c[k].c2, c[k].c3);
            double* out = u + 2 * (i + lanes * k);
            _mm512_storeu_pd(out, _mm512_permutex2var_pd(even, lower, odd));
            _mm512_storeu_pd(out + lanes, _mm512_permutex2var_pd(even, upper, odd));
        }
    }
}

}  // namespace covaria::detail
