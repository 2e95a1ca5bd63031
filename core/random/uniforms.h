// Addressed uniform draws: every number is a pure function of (seed, purpose, component, trial).
#pragma once

#include <cstdint>
#include <span>

namespace covaria {

/// Separate streams of one seed. The values are part of the results' reproducibility: never renumber.
enum class DrawPurpose : std::uint32_t {
    trials = 0,              ///< the trials of a Monte Carlo run
    observations = 1,        ///< synthetic observations
    variance_estimates = 2,  ///< how far an estimate of variance lies off; its index for the component
    design_starts = 3,       ///< starts of the search for a design; the number of the start for the component
    sobol_shifts = 16        ///< in batches of Sobol points; and as many after it as there are purposes
};

/// u[t] = uniform draw of trial `first_trial + t` for one component, strictly inside (0, 1):
/// (v + 1/2) 2^-52 with v of 52 bits (53 bits could round to exactly 1). Philox4x32-10 with key = seed and
/// counter = (trial / 2, component, purpose); the two 64-bit words of one counter serve an even trial and
/// its odd successor. Element t depends on its own address only, however the trials are blocked.
void uniforms(std::uint64_t seed, DrawPurpose purpose, std::uint32_t component, std::uint64_t first_trial,
              std::span<double> u);

}  // namespace covaria
