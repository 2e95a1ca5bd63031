// Control of a long computation from outside: stop, progress, number of threads.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

namespace covaria {

class UnitStore;  // core/base/unit_store.h

/// Trials, grid points or evaluations.
struct Progress {
    std::uint64_t trials_done = 0;
    std::uint64_t trials_planned = 0;  ///< 0 = not known (adaptive)
    std::optional<double> best = {};   ///< smallest objective of a search so far
};

struct RunControl {
    std::stop_token stop = {};
    /// Called only on the thread that called the engine, some ten times a second at most. May be empty.
    std::function<void(const Progress&)> progress = {};
    int threads = 0;             ///< 0 = as many as the machine has
    UnitStore* units = nullptr;  ///< set where the computation is shared with other processes
};

}  // namespace covaria
