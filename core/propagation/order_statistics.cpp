// Coverage intervals from the two tails of an output.
#include "core/propagation/order_statistics.h"

#include <algorithm>
#include <cmath>

namespace covaria::detail {

CoverageRanks coverage_ranks(std::uint64_t trials, double probability) {
    const double exact = probability * static_cast<double>(trials);
    // 0.95 * 100000 is not an integer in binary: take what is one up to rounding.
    const double nearest = std::round(exact);
    const bool integer = std::abs(exact - nearest) <= 1e-9 + 1e-15 * exact;
    auto q = static_cast<std::uint64_t>(integer ? nearest : std::floor(exact + 0.5));
    if (trials >= 2) q = std::clamp<std::uint64_t>(q, 1, trials - 1);
    return {trials, q, (trials - q + 1) / 2};
}

namespace {

/// y_(r) and y_(r+q): the latter is the (M - q - r + 1)-th from above.
CoverageInterval interval_at(const Tails& tails, const CoverageRanks& ranks, std::uint64_t r) {
    return {tails.low.value(r), tails.high.value(ranks.trials - ranks.q - r + 1)};
}

}  // namespace

CoverageInterval symmetric_interval(const Tails& tails, const CoverageRanks& ranks) {
    if (ranks.trials < 2) return {tails.low.value(1), tails.low.value(1)};
    return interval_at(tails, ranks, ranks.r);
}

CoverageInterval shortest_interval(const Tails& tails, const CoverageRanks& ranks) {
    if (ranks.trials < 2) return symmetric_interval(tails, ranks);
    const std::uint64_t last = ranks.trials - ranks.q;
    std::vector<std::uint64_t> candidates = tails.low.corners(last);
    if (!tails.low.exact() || !tails.high.exact()) {
        for (std::uint64_t from_above : tails.high.corners(last)) candidates.push_back(last + 1 - from_above);
        std::sort(candidates.begin(), candidates.end());
    }
    CoverageInterval best = interval_at(tails, ranks, 1);
    for (std::uint64_t r : candidates) {
        const CoverageInterval interval = interval_at(tails, ranks, r);
        if (interval.high - interval.low < best.high - best.low) best = interval;
    }
    return best;
}

}  // namespace covaria::detail
