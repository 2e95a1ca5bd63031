// Sobol points, scrambled anew in each batch: trials that fill the space of the draws evenly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/random/uniforms.h"

namespace covaria {

/// Dimensions are the addresses of draws: components first, then estimates of variance. Batch b holds the
/// first `batch_trials` points, the bits of each dimension turned over by a random number of (seed,
/// dimension, batch) (digital shift: each point is uniform, and batches are independent). Direction numbers
/// of Joe and Kuo (SIAM J. Sci. Comput. 30 (2008) 2635) from Boost; dimensions beyond its table are plain
/// draws.
class SobolPoints {
public:
    SobolPoints(std::uint64_t seed, std::size_t components, std::size_t estimates,
                std::uint64_t batch_trials);
    std::uint64_t batch_trials() const { return batch_trials_; }
    /// Fills u as `uniforms` does, with the seed of the constructor.
    void fill(DrawPurpose purpose, std::uint32_t address, std::uint64_t first_trial,
              std::span<double> u) const;

private:
    static constexpr std::size_t bits = 30;  ///< bits of the index of a point in its batch
    struct Dimension {
        std::uint64_t directions[bits];
    };
    void fill_batch(const Dimension& dimension, std::uint64_t shift, std::uint64_t index,
                    std::span<double> u) const;

    std::uint64_t seed_;
    std::size_t components_;
    std::uint64_t batch_trials_;
    std::vector<Dimension> dimensions_;
};

}  // namespace covaria
