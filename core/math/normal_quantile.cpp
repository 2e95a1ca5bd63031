// Wichura's AS 241 on vectors: the central formula for every element, the tail formulae for those gathered
// from a chunk.
#include "core/math/normal_quantile.h"

#include <immintrin.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/processor.h"
#include "core/math/batch_transform.h"

namespace covaria {

namespace {

using Batch = xsimd::batch<double>;
using Coefficients = std::array<double, 8>;

/// Coefficients of PPND16, in the letters of the paper.
namespace ppnd16 {
constexpr Coefficients a{3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3,
                         1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4,
                         3.3430575583588128105e4, 2.5090809287301226727e3};
constexpr Coefficients b{1.0,
                         4.2313330701600911252e1,
                         6.8718700749205790830e2,
                         5.3941960214247511077e3,
                         2.1213794301586595867e4,
                         3.9307895800092710610e4,
                         2.8729085735721942674e4,
                         5.2264952788528545610e3};
constexpr Coefficients c{1.42343711074968357734e0,  4.63033784615654529590e0, 5.76949722146069140550e0,
                         3.64784832476320460504e0,  1.27045825245236838258e0, 2.41780725177450611770e-1,
                         2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr Coefficients d{1.0,
                         2.05319162663775882187e0,
                         1.67638483018380384940e0,
                         6.89767334985100004550e-1,
                         1.48103976427480074590e-1,
                         1.51986665636164571966e-2,
                         5.47593808499534494600e-4,
                         1.05075007164441684324e-9};
constexpr Coefficients e{6.65790464350110377720e0,  5.46378491116411436990e0,  1.78482653991729133580e0,
                         2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
                         2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr Coefficients f{1.0,
                         5.99832206555887937690e-1,
                         1.36929880922735805310e-1,
                         1.48753612908506148525e-2,
                         7.86869131145613259100e-4,
                         1.84631831751005468180e-5,
                         1.42151175831644588870e-7,
                         2.04426310338993978564e-15};
}  // namespace ppnd16

constexpr double half_width_of_centre = 0.425;

Batch central(Batch p) {
    const Batch q = p - Batch(0.5);
    const Batch r = Batch(half_width_of_centre * half_width_of_centre) - q * q;
    return q * polynomial(ppnd16::a, r) / polynomial(ppnd16::b, r);
}

Batch tail(Batch p) {
    const Batch smaller = xsimd::min(p, Batch(1.0) - p);
    const Batch r = xsimd::sqrt(-xsimd::log(smaller));
    const Batch near = r - Batch(1.6);
    Batch z = polynomial(ppnd16::c, near) / polynomial(ppnd16::d, near);
    const auto is_far = r > Batch(5.0);
    if (xsimd::any(is_far)) {
        const Batch far = r - Batch(5.0);
        z = xsimd::select(is_far, polynomial(ppnd16::e, far) / polynomial(ppnd16::f, far), z);
        const Batch infinite(std::numeric_limits<double>::infinity());
        z = xsimd::select(r == infinite, infinite, z);
    }
    return xsimd::select(p < Batch(0.5), -z, z);
}

bool in_tail(double p) {
    return std::abs(p - 0.5) > half_width_of_centre;
}

/// Needs p.size() <= SetApart::chunk.
void centre_of_chunk(std::span<const double> p, std::span<double> z, SetApart& tails) {
    tails.gather(p, in_tail);
    transform_batches(p, z, 0.5, central);
}

COVARIA_AVX512 inline __m512d wide_polynomial(const Coefficients& coefficients, __m512d x) {
    __m512d sum = _mm512_set1_pd(coefficients.back());
    for (std::size_t i = coefficients.size() - 1; i-- > 0;)
        sum = _mm512_fmadd_pd(sum, x, _mm512_set1_pd(coefficients[i]));
    return sum;
}

/// The same bits: the same operations on eight elements.
COVARIA_AVX512 void centre_of_chunk_avx512(std::span<const double> p, std::span<double> z, SetApart& tails) {
    const __m512d half = _mm512_set1_pd(0.5), edge = _mm512_set1_pd(half_width_of_centre);
    const __m512d edge2 = _mm512_set1_pd(half_width_of_centre * half_width_of_centre);
    const __m256i lane = _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0);
    for (std::size_t i = 0; i < p.size(); i += 8) {
        const auto there = static_cast<__mmask8>(p.size() - i >= 8 ? 0xFF : (1u << (p.size() - i)) - 1u);
        const __m512d value = _mm512_mask_loadu_pd(half, there, &p[i]);
        const __m512d q = _mm512_sub_pd(value, half);
        const __mmask8 apart = _mm512_cmp_pd_mask(_mm512_abs_pd(q), edge, _CMP_GT_OQ);
        const __m256i place = _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(i)), lane);
        _mm512_storeu_pd(&tails.values[tails.count], _mm512_maskz_compress_pd(apart, value));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(&tails.places[tails.count]),
                            _mm256_maskz_compress_epi32(apart, place));
        tails.count += static_cast<std::size_t>(std::popcount(static_cast<unsigned>(apart)));
        const __m512d r = _mm512_sub_pd(edge2, _mm512_mul_pd(q, q));
        _mm512_mask_storeu_pd(
            &z[i], there,
            _mm512_div_pd(_mm512_mul_pd(q, wide_polynomial(ppnd16::a, r)), wide_polynomial(ppnd16::b, r)));
    }
}

template <class Centre>
void by_chunks(std::span<const double> p, std::span<double> z, const Centre& centre) {
    for_chunks(p, z, [&centre](std::span<const double> from, std::span<double> to) {
        SetApart tails;
        centre(from, to, tails);
        tails.transform(to, 0.01, tail);
    });
}

}  // namespace

void detail::normal_quantiles_avx2(std::span<const double> p, std::span<double> z) {
    by_chunks(p, z, centre_of_chunk);
}

void detail::normal_quantiles_avx512(std::span<const double> p, std::span<double> z) {
    by_chunks(p, z, centre_of_chunk_avx512);
}

void normal_quantiles(std::span<const double> p, std::span<double> z) {
    has_avx512() ? detail::normal_quantiles_avx512(p, z) : detail::normal_quantiles_avx2(p, z);
}

double normal_quantile(double p) {
    double z = 0.0;
    normal_quantiles({&p, 1}, {&z, 1});
    return z;
}

double normal_distribution_function(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

void normal_distribution_functions(std::span<const double> z, std::span<double> p) {
    transform_batches(
        z, p, 0.0, [](Batch x) { return Batch(0.5) * xsimd::erfc(x * Batch(-1.0 / std::numbers::sqrt2)); });
}

double normal_density(double z) {
    return std::exp(-0.5 * z * z) * (0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2);
}

}  // namespace covaria
