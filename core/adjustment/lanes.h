// Several right-hand sides of the same equations at once: a number for each of them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/math/real.h"

namespace covaria::adjustment {

/// Numbers side by side, one for each right-hand side: packs of some (`Batch`), or one (`double`).
template <class Pack, std::size_t Packs>
struct Lanes {
    using Real = Pack;
    static constexpr std::size_t of_pack = sizeof(Pack) / sizeof(double), count = Packs,
                                 size = Packs * of_pack;
    std::array<Pack, Packs> packs;

    Lanes() : Lanes(0.0) {}
    explicit Lanes(double all) {
        for_packs([&](auto p) { packs[p] = Pack(all); });
    }
    static Lanes load(const double* numbers) {
        Lanes loaded;
        for_packs([&](auto p) {
            if constexpr (of_pack == 1)
                loaded.packs[p] = numbers[p];
            else
                loaded.packs[p] = Pack::load_unaligned(numbers + p * of_pack);
        });
        return loaded;
    }
    void store(double* numbers) const {
        for_packs([&](auto p) {
            if constexpr (of_pack == 1)
                numbers[p] = packs[p];
            else
                packs[p].store_unaligned(numbers + p * of_pack);
        });
    }
    Lanes& operator/=(double by) {
        for_packs([&](auto p) { packs[p] /= Pack(by); });
        return *this;
    }
    /// sum += factor * number.
    friend void add_product(Lanes& sum, double factor, const Lanes& number) {
        using std::fma;
        using xsimd::fma;
        const Pack by(factor);
        for_packs([&](auto p) { sum.packs[p] = fma(by, number.packs[p], sum.packs[p]); });
    }

    /// f(0), f(1) ... of all packs, not in a loop: sums then stay in registers.
    template <class F>
    static void for_packs(const F& f) {
        [&]<std::size_t... p>(std::index_sequence<p...>) {
            (f(std::integral_constant<std::size_t, p>()), ...);
        }
        (std::make_index_sequence<Packs>());
    }
};

/// sum += factor * number.
inline void add_product(double& sum, double factor, double number) {
    sum += factor * number;
}

using OneLane = Lanes<double, 1>;
/// The more there are, the less often the factor is fetched, as long as what is changed stays in the cache.
using FewLanes = Lanes<Batch, 2>;
using ManyLanes = Lanes<Batch, 4>;

}  // namespace covaria::adjustment
