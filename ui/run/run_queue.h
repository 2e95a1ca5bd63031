// Runs that were asked for, one after the other in a worker thread.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <deque>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "core/base/run_control.h"
#include "ui/jobs/job_queue.h"
#include "ui/run/run_state.h"

namespace covaria::ui {

/// Names a run: an analysis, or a study or design of one.
struct RunKey {
    std::string analysis;
    std::string inquiry = {};
    auto operator<=>(const RunKey&) const = default;
};

/// A key waits once. What it runs is asked for when its turn comes: the latest state wins.
class RunQueue : public QObject {
    Q_OBJECT
public:
    /// Called on the worker thread; what it returns is called on the owner's.
    using Run = std::function<JobQueue::Delivery(const RunControl& control)>;
    /// The run of a key whose turn has come; called on the owner's thread. None: it waits until the next
    /// call of `begin`, and the others with it.
    using Begin = std::function<Run(const RunKey& key)>;

    RunQueue(Begin begin, Execution execution, QObject* parent = nullptr);
    ~RunQueue() override;

    void push(const RunKey& key);
    void begin();  ///< starts the next that waits
    /// Follows a change: waiting runs begin at once after a rest, and while changes follow each other closely
    /// (typing, dragging) when they have ceased for a moment: the law of propagation has the processor to
    /// itself.
    void settle();
    bool waits(const RunKey& key) const;
    /// Keys of the runs that wait.
    const std::deque<RunKey>& waiting() const { return waiting_; }
    bool take_out(const RunKey& key);  ///< whether it waited
    /// Asks the run of the key to stop; tells whether it runs.
    bool stop(const RunKey& key);
    void stop_active() { stop_.request_stop(); }
    /// Runs of the analysis looked at come before the others.
    void set_focus(const std::string& analysis) { focus_ = analysis; }
    void set_threads(int threads) { threads_ = threads; }  ///< 0 = as many as the machine has
    bool is_busy() const { return active_ || !waiting_.empty(); }
    /// Called from inside a run: `message` is then called on the owner's thread.
    void post(JobQueue::Delivery message) { jobs_.post(std::move(message)); }

signals:
    /// Sent some ten times a second at most.
    void progress_changed(const covaria::ui::RunKey& key, const covaria::ui::RunProgress& progress);
    /// The run has thrown: memory that is not there, a defect of the program. `ended` follows.
    void failed(const covaria::ui::RunKey& key, const covaria::Error& error);
    /// The run is over, and its delivery has been taken.
    void ended(const covaria::ui::RunKey& key);
    void idle();

private:
    void start(const RunKey& key, Run run);
    void finish(const JobQueue::Delivery& delivery);

    Begin begin_;
    std::deque<RunKey> waiting_;
    std::optional<RunKey> active_;
    std::string focus_;
    int threads_ = 0;
    quint64 number_ = 0;  ///< counts runs: progress of a former one is not shown
    std::stop_source stop_;
    QElapsedTimer time_;
    QTimer settling_;
    QElapsedTimer last_change_;
    Execution execution_;
    JobQueue jobs_;  ///< last member: its thread ends first
};

}  // namespace covaria::ui
