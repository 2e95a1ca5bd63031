// Applies a function of xsimd batches to a span so that element i depends on its own argument only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <xsimd/xsimd.hpp>

namespace covaria {

/// x[i] = f(p[i]) for a function of `xsimd::batch<double>`; `p` and `x` have the same length and may be the
/// same memory. The last few elements are padded with `padding` and go through the same instructions, so
/// results are bit-identical for any blocking.
template <class Function>
void transform_batches(std::span<const double> p, std::span<double> x, double padding, Function&& f) {
    using Pack = xsimd::batch<double>;
    constexpr std::size_t lanes = Pack::size;
    const std::size_t whole = p.size() - p.size() % lanes;
    for (std::size_t i = 0; i < whole; i += lanes) f(Pack::load_unaligned(&p[i])).store_unaligned(&x[i]);
    if (whole == p.size()) return;
    std::array<double, lanes> last;
    last.fill(padding);
    for (std::size_t i = whole; i < p.size(); ++i) last[i - whole] = p[i];
    f(Pack::load_unaligned(last.data())).store_unaligned(last.data());
    for (std::size_t i = whole; i < p.size(); ++i) x[i] = last[i - whole];
}

/// Elements of a chunk that need another formula than most: gathered, transformed, put back.
class SetApart {
public:
    static constexpr std::size_t chunk = 256;  // small enough for the stack and the first-level cache

    /// Gathers the elements of p (of at most `chunk`) for which `apart(p[i])`.
    template <class Predicate>
    void gather(std::span<const double> p, Predicate&& apart) {
        for (std::size_t i = 0; i < p.size(); ++i) {  // without a branch: which ones, nobody can predict
            values[count] = p[i];
            places[count] = static_cast<std::uint32_t>(i);
            count += apart(p[i]) ? 1 : 0;
        }
    }
    template <class Function>
    void transform(std::span<double> x, double padding, Function&& f) {
        const std::span<double> gathered(values.data(), count);
        transform_batches(gathered, gathered, padding, f);
        for (std::size_t i = 0; i < count; ++i) x[places[i]] = values[i];
    }

    std::array<double, chunk + 8> values;  // 8 more, as a vector may write beyond the end
    std::array<std::uint32_t, chunk + 8> places;
    std::size_t count = 0;
};

/// f(chunk of p, chunk of x) for chunks of at most `SetApart::chunk`.
template <class Function>
void for_chunks(std::span<const double> p, std::span<double> x, Function&& f) {
    for (std::size_t begin = 0; begin < p.size(); begin += SetApart::chunk) {
        const std::size_t length = std::min(SetApart::chunk, p.size() - begin);
        f(p.subspan(begin, length), x.subspan(begin, length));
    }
}

/// c[0] + c[1] x + c[2] x^2 + ... by Horner's rule with fused multiply-add.
template <std::size_t N>
xsimd::batch<double> polynomial(const std::array<double, N>& c, xsimd::batch<double> x) {
    xsimd::batch<double> sum(c[N - 1]);
    for (std::size_t i = N - 1; i-- > 0;) sum = xsimd::fma(sum, x, xsimd::batch<double>(c[i]));
    return sum;
}

}  // namespace covaria
