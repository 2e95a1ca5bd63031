// One worker thread that runs jobs in order; what a job returns is called on the owner's thread.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>

namespace covaria::ui {

enum class Execution {
    threads,
    inline_execution,  ///< at once on the caller's thread: the synchronous twin for tests and scripts
};

class JobQueue {
public:
    using Delivery = std::function<void()>;  ///< called on the owner's thread; may be empty
    using Job = std::function<Delivery()>;   ///< called on the worker thread

    JobQueue(QObject* owner, Execution execution);
    ~JobQueue();
    JobQueue(const JobQueue&) = delete;
    JobQueue& operator=(const JobQueue&) = delete;

    void push(Job job);
    /// From inside a job: a message for the owner's thread.
    void post(Delivery message);
    void wait() { pool_.waitForDone(); }

private:
    QObject* owner_;
    Execution execution_;
    QThreadPool pool_;
};

}  // namespace covaria::ui
