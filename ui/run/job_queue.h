// One worker thread that runs jobs in order; what a job returns is called on the owner's thread.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>

#include "core/base/error.h"

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

    /// On the owner's thread, when a job has thrown: memory that is not there, a defect of the program.
    using Failure = std::function<void(const Error&)>;

    /// What a job throws ends here, never the program: `failure` is called in place of what it would return;
    /// it may be empty.
    void push(Job job, Failure failure);
    /// From inside a job: a message for the owner's thread.
    void post(Delivery message);
    void wait() { pool_.waitForDone(); }

private:
    QObject* owner_;
    Execution execution_;
    QThreadPool pool_;
};

}  // namespace covaria::ui
