// Work of which only the newest matters.
#pragma once

#include <atomic>
#include <functional>
#include <stop_token>

#include "ui/jobs/job_queue.h"

namespace covaria::ui {

/// A job that waits gives way to the next one. What one delivers that has been overtaken while it ran is
/// dropped, or, where every step is worth seeing, delivered as well.
class LatestJob {
public:
    enum class Overtaken { dropped, delivered };
    /// Called on the worker thread.
    using Job = std::function<JobQueue::Delivery(const std::stop_token& stop)>;

    explicit LatestJob(Execution execution, Overtaken overtaken = Overtaken::dropped);
    ~LatestJob();

    /// `failure`: as JobQueue::push; overtaken like what is delivered.
    void start(Job job, JobQueue::Failure failure);
    /// Delivers nothing more of what was started; the job that runs is asked to stop.
    void cancel();
    /// Whether the newest job has not been delivered yet.
    bool is_busy() const { return awaited_; }

private:
    void deliver(quint64 number, const JobQueue::Delivery& delivery);

    Overtaken overtaken_;
    bool awaited_ = false;
    std::atomic<quint64> number_ = 0;
    quint64 cancelled_ = 0;  ///< jobs up to this number
    std::stop_source stop_;
    JobQueue jobs_;  ///< last member: its thread ends first
};

}  // namespace covaria::ui
