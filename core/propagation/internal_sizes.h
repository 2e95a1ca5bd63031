// Sizes inside the engine that tests change and users do not.
#pragma once

#include <cstddef>
#include <cstdint>

namespace covaria::detail {

struct EngineSettings {
    std::size_t tail_bytes = std::size_t{256} << 20;  ///< memory of values kept for exact coverage intervals
    double tail_margin =
        5.0;  ///< standard errors of the pilot by which the kept tails are longer than needed
    std::uint64_t region_trials = 100'000;            ///< most trials for the factors of coverage regions
    std::size_t batch_bytes = std::size_t{32} << 20;  ///< outputs of one adaptive batch kept by a thread
};

}  // namespace covaria::detail
