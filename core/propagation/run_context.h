// Context that the passes over the trials of one evaluation share.
#pragma once

#include "core/propagation/internal_sizes.h"
#include "core/propagation/run_monitor.h"
#include "core/propagation/trial_block_runner.h"

namespace covaria::detail {

struct RunContext {
    const TrialSource& source;
    double probability;  ///< coverage probability
    const EngineSettings& settings;
    RunMonitor& monitor;
};

}  // namespace covaria::detail
