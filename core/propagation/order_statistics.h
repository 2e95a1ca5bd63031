// Coverage intervals from the two tails of an output (JCGM 101 7.7).
#pragma once

#include <cstdint>

#include "core/propagation/tail.h"
#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// q and r of JCGM 101 7.7.2: q = pM if an integer, else floor(pM + 1/2); r = (M - q)/2 if an integer, else
/// floor((M - q + 1)/2). Always 1 <= r and r + q <= M, for M >= 2.
struct CoverageRanks {
    std::uint64_t trials = 0, q = 0, r = 0;
};
CoverageRanks coverage_ranks(std::uint64_t trials, double probability);

/// Values a tail must hold for both intervals.
inline std::uint64_t needed_tail(const CoverageRanks& ranks) {
    return ranks.trials - ranks.q;
}

struct Tails {
    Tail low, high;
};

/// [y_(r), y_(r+q)] and the shortest of all [y_(r), y_(r+q)], the first of equals (7.7.2, 7.7.4). The tails
/// are finished and hold `needed_tail` values each.
CoverageInterval symmetric_interval(const Tails& tails, const CoverageRanks& ranks);
CoverageInterval shortest_interval(const Tails& tails, const CoverageRanks& ranks);

}  // namespace covaria::detail
