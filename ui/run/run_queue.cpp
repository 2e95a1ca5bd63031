#include "ui/run/run_queue.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace covaria::ui {

namespace {

using namespace std::chrono_literals;
constexpr auto settling_time = 120ms;  // without a further change, before a live run starts
constexpr auto alone_time = 500ms;     // a change after as long a rest is taken for one by itself

}  // namespace

RunQueue::RunQueue(Begin begin, Execution execution, QObject* parent)
    : QObject(parent), begin_(std::move(begin)), execution_(execution), jobs_(execution) {
    settling_.setSingleShot(true);
    settling_.setInterval(settling_time);
    connect(&settling_, &QTimer::timeout, this, &RunQueue::begin);
}

RunQueue::~RunQueue() {
    stop_.request_stop();
    jobs_.wait();
}

void RunQueue::push(const RunKey& key) {
    if (!waits(key)) waiting_.push_back(key);
}

void RunQueue::settle() {
    const bool alone = !last_change_.isValid() || last_change_.hasExpired(alone_time.count());
    last_change_.start();
    if (alone || execution_ == Execution::inline_execution)
        begin();
    else
        settling_.start();
}

void RunQueue::begin() {
    settling_.stop();
    while (!active_ && !waiting_.empty()) {
        auto next = std::find_if(waiting_.begin(), waiting_.end(),
                                 [&](const RunKey& key) { return key.analysis == focus_; });
        if (next == waiting_.end()) next = waiting_.begin();
        const RunKey key = *next;
        Run run = begin_(key);
        if (!run) return;
        waiting_.erase(next);
        start(key, std::move(run));
    }
}

void RunQueue::start(const RunKey& key, Run run) {
    active_ = key;
    stop_ = std::stop_source();
    time_.start();
    RunControl control{stop_.get_token(), {}, threads_};
    control.progress = [this, key, number = ++number_](const Progress& progress) {
        jobs_.post([this, key, number, progress] {
            if (!active_ || number != number_) return;
            emit progress_changed(key,
                                  progress_after(progress, static_cast<double>(time_.elapsed()) / 1000.0));
        });
    };
    jobs_.push(
        [this, run = std::move(run), control]() -> JobQueue::Delivery {
            return [this, delivery = run(control)] { finish(delivery); };
        },
        [this, key](const Error& error) { finish([&] { emit failed(key, error); }); });
}

void RunQueue::finish(const JobQueue::Delivery& delivery) {
    if (delivery) delivery();
    const RunKey key = *std::exchange(active_, std::nullopt);
    emit ended(key);
    if (!settling_.isActive()) begin();
    if (!is_busy()) emit idle();
}

bool RunQueue::waits(const RunKey& key) const {
    return std::find(waiting_.begin(), waiting_.end(), key) != waiting_.end();
}

bool RunQueue::take_out(const RunKey& key) {
    return std::erase(waiting_, key) > 0;
}

bool RunQueue::stop(const RunKey& key) {
    if (active_ != key) return false;
    stop_.request_stop();
    return true;
}

}  // namespace covaria::ui
