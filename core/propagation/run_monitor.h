// Stop requests and progress of one evaluation, shared by its threads.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>

#include "core/base/run_control.h"

namespace covaria::detail {

class RunMonitor {
public:
    /// `planned` = 0 when the number of trials is not known.
    RunMonitor(const RunControl& control, std::uint64_t planned);

    bool stopped() const { return control_.stop.stop_requested(); }
    /// After each block: counts its trials. On the calling thread reports progress now and then. False: stop.
    bool advance(std::uint64_t trials);
    int threads() const { return threads_; }
    UnitStore* units() const { return control_.units; }

private:
    const RunControl& control_;
    std::uint64_t planned_;
    int threads_;
    std::thread::id caller_;
    std::atomic<std::uint64_t> done_{0};
    std::chrono::steady_clock::time_point last_report_;  ///< calling thread only
};

}  // namespace covaria::detail
