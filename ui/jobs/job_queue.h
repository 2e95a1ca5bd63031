// One worker thread that runs jobs in order; what a job returns is called on the owner's thread.
#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "core/base/error.h"

namespace covaria::ui {

enum class Execution {
    threads,
    inline_execution,  ///< at once on the caller's thread: the synchronous twin for tests and scripts
};

/// Messages for the thread in which it was made. Qt carries only the word that there is one: what is in them
/// passes through a lock of our own, which the thread sanitizer sees.
class Inbox : public QObject {
    Q_OBJECT
public:
    void post(std::function<void()> message);  ///< from any thread

private:
    Q_INVOKABLE void take();

    std::mutex mutex_;
    std::deque<std::function<void()>> messages_;
};

class JobQueue {
public:
    using Delivery = std::function<void()>;  ///< called on the owner's thread; may be empty
    using Job = std::function<Delivery()>;   ///< called on the worker thread

    /// Made, and destroyed, in the thread of its owner; what has not been delivered then is dropped.
    explicit JobQueue(Execution execution);
    ~JobQueue();
    JobQueue(const JobQueue&) = delete;
    JobQueue& operator=(const JobQueue&) = delete;

    /// Called on the owner's thread when a job has thrown: memory that is not there, a defect of the program.
    using Failure = std::function<void(const Error&)>;

    /// Exceptions of a job end here, never the program: `failure` is called in place of what it would return;
    /// it may be empty.
    void push(Job job, Failure failure);
    /// Called from inside a job: a message for the owner's thread.
    void post(Delivery message);
    /// Waits until every job has ended.
    void wait();

private:
    void work();

    Execution execution_;
    Inbox inbox_;
    std::mutex mutex_;  ///< guards the members below, but the thread
    std::condition_variable changed_;
    std::deque<std::function<void()>> jobs_;  ///< the one that runs is the first
    bool ending_ = false;
    std::thread worker_;  ///< begun with the first job
};

}  // namespace covaria::ui
