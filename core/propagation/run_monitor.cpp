// Stop requests and progress of one evaluation.
#include "core/propagation/run_monitor.h"

#include <algorithm>

namespace covaria::detail {

namespace {
constexpr std::chrono::milliseconds report_interval{100};
}

RunMonitor::RunMonitor(const RunControl& control, std::uint64_t planned)
    : control_(control),
      planned_(planned),
      threads_(control.threads > 0 ? control.threads
                                   : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
      caller_(std::this_thread::get_id()),
      last_report_(std::chrono::steady_clock::now()) {}

bool RunMonitor::advance(std::uint64_t trials) {
    const std::uint64_t done = done_.fetch_add(trials, std::memory_order_relaxed) + trials;
    if (control_.progress && std::this_thread::get_id() == caller_) {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_report_ >= report_interval) {
            last_report_ = now;
            control_.progress({planned_ > 0 ? std::min(done, planned_) : done, planned_});
        }
    }
    return !stopped();
}

}  // namespace covaria::detail
