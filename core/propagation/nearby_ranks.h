// Weights by which a smooth function of the rank is read at one rank from its noisy values at the ranks
// around it.
#pragma once

#include <cstdint>
#include <vector>

namespace covaria::detail {

/// Weights of the ranks first ... first + size - 1; they sum to 1.
struct RankWeights {
    std::uint64_t first = 1;
    std::vector<double> weights;
};

/// Ranks from half of `rank` to one and a half of it, of `count` > rank values. The weights are those of the
/// least-squares parabola in z, the normal quantile that belongs to a rank: exact for functions that are
/// parabolas in z.
RankWeights weights_around(std::uint64_t rank, std::uint64_t count);

}  // namespace covaria::detail
