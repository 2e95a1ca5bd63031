// Propagation of distributions: all trials of a run, on all threads, in bounded memory (JCGM 101 7, JCGM 102
// 7).
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/propagation/unit_statistics.h"

namespace covaria::detail {

class AdaptiveProcedure;
class BatchEstimates;

struct RunSize {
    std::uint64_t trials = 0;              ///< largest number of trials
    std::uint64_t per_unit = unit_trials;  ///< trials of a unit, or of a batch of the adaptive procedure
    std::uint64_t units() const { return (trials + per_unit - 1) / per_unit; }
};

/// Findings of a run, before intervals are taken from them.
struct MonteCarloRun {
    Moments moments;
    std::vector<Tails> tails;
    std::vector<std::vector<std::uint64_t>> cells;
    std::vector<std::vector<std::uint64_t>> parts;  ///< counts of the divided cells
    Pilot pilot;
    std::uint64_t trials = 0;  ///< made, with those that have no value
    std::uint64_t units = 0;
    bool exact = true;  ///< intervals come from all values, not from cells
    std::vector<ConvergencePoint> convergence;

    std::uint64_t failed() const { return trials - moments.count(); }
};

/// Observers of the batches (units) of a run as they come, in their order.
struct BatchWatch {
    AdaptiveProcedure* adaptive = nullptr;  ///< null: exactly `size.trials` trials
    BatchEstimates* estimates = nullptr;    ///< takes complete batches
};

/// `pilot`: as from `run_pilot` with the same context. Error: cancelled.
Result<MonteCarloRun> run_monte_carlo(const RunContext& context, Pilot pilot, RunSize size, BatchWatch watch);

/// The statistics of each output. Finishes (sorts) the tails.
Result<std::vector<MonteCarloOutput>> outputs_of(MonteCarloRun& run, double probability, RunMonitor& monitor);

}  // namespace covaria::detail
