// Units of work on several threads, their results merged strictly in order: the same bits for any number of
// threads.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/propagation/run_monitor.h"

namespace covaria::detail {

enum class WorkEnd {
    complete,   ///< all units merged
    enough,     ///< `merge` said so; later units were dropped
    cancelled,  ///< stop was requested
};

/// The work. `make_worker` is called once on each thread and returns a function that fills the partial
/// result of a unit (false: stop was requested). `merge` is called for units 0, 1, 2 ... one at a time, on
/// any thread; false: enough.
template <class Partial>
struct OrderedWork {
    std::uint64_t units = 0;
    std::function<Partial()> make_partial;
    std::function<std::function<bool(std::uint64_t, Partial&)>()> make_worker;
    std::function<bool(std::uint64_t, Partial&)> merge;
    bool ends_with_enough = false;  ///< `merge` decides by what it has: it may end before the last unit
};

/// Workers take unit numbers; at most two partial results per thread exist, so memory is bounded however
/// slow one unit is. The calling thread works too.
template <class Partial>
class OrderedRun {
public:
    OrderedRun(const OrderedWork<Partial>& work, RunMonitor& monitor)
        : work_(work), monitor_(monitor), slots_(2 * static_cast<std::size_t>(monitor.threads())) {}

    WorkEnd run() {
        {
            std::vector<std::jthread> helpers;
            for (int i = 1; i < monitor_.threads() && static_cast<std::uint64_t>(i) < work_.units; ++i)
                helpers.emplace_back([this] { work_loop(); });
            work_loop();
        }
        if (failure_) std::rethrow_exception(failure_);
        if (enough_) return WorkEnd::enough;
        return merged_ == work_.units ? WorkEnd::complete : WorkEnd::cancelled;
    }

private:
    struct Slot {
        std::optional<Partial> partial;
        bool finished = false;
    };

    void work_loop() {
        try {
            const auto worker = work_.make_worker();
            while (const std::optional<std::uint64_t> unit = take_unit()) {
                Slot& slot = slots_[*unit % slots_.size()];
                if (!slot.partial) slot.partial.emplace(work_.make_partial());
                if (!worker(*unit, *slot.partial)) return finish();
                merge_finished(slot);
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
            over_ = true;
            changed_.notify_all();
        }
    }

    /// The next unit, as soon as its slot is free; none when all is taken or the run is over.
    std::optional<std::uint64_t> take_unit() {
        std::unique_lock lock(mutex_);
        for (;;) {
            if (over_ || next_ == work_.units || monitor_.stopped()) return {};
            if (next_ < merged_ + slots_.size()) return next_++;
            changed_.wait_for(lock, std::chrono::milliseconds(50));
            lock.unlock();
            monitor_.advance(0);
            lock.lock();
        }
    }

    void merge_finished(Slot& slot) {
        const std::lock_guard lock(mutex_);
        slot.finished = true;
        while (!over_ && merged_ < work_.units && slots_[merged_ % slots_.size()].finished) {
            Slot& next = slots_[merged_ % slots_.size()];
            if (!work_.merge(merged_, *next.partial)) enough_ = over_ = true;
            next.finished = false;
            ++merged_;
        }
        changed_.notify_all();
    }

    void finish() {
        const std::lock_guard lock(mutex_);
        over_ = true;
        changed_.notify_all();
    }

    const OrderedWork<Partial>& work_;
    RunMonitor& monitor_;
    std::vector<Slot> slots_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t next_ = 0;
    std::uint64_t merged_ = 0;
    bool over_ = false;
    bool enough_ = false;
    std::exception_ptr failure_;
};

template <class Partial>
WorkEnd run_in_order(const OrderedWork<Partial>& work, RunMonitor& monitor) {
    return OrderedRun<Partial>(work, monitor).run();
}

/// `task(i)` for i = 0 ... count - 1 on several threads, in any order: for tasks that write to places of
/// their own. Cancelled when stop is requested between tasks.
inline WorkEnd run_each(std::uint64_t count, RunMonitor& monitor,
                        const std::function<void(std::uint64_t)>& task) {
    struct Nothing {};
    OrderedWork<Nothing> work;
    work.units = count;
    work.make_partial = [] { return Nothing{}; };
    work.make_worker = [&task, &monitor] {
        return [&task, &monitor](std::uint64_t i, Nothing&) {
            task(i);
            return monitor.advance(0);
        };
    };
    work.merge = [](std::uint64_t, Nothing&) { return true; };
    return run_in_order(work, monitor);
}

}  // namespace covaria::detail
