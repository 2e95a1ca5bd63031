// A thread pool of one thread.
#include "ui/run/job_queue.h"

#include <QMetaObject>

#include "core/base/guarded.h"

namespace covaria::ui {

namespace {

JobQueue::Delivery delivery_of(const JobQueue::Job& job, const JobQueue::Failure& failure) {
    auto made = guarded(job);
    if (made) return *std::move(made);
    if (!failure) return {};
    return [failure, error = made.error()] { failure(error); };
}

}  // namespace

JobQueue::JobQueue(QObject* owner, Execution execution) : owner_(owner), execution_(execution) {
    pool_.setMaxThreadCount(1);
}

JobQueue::~JobQueue() {
    pool_.waitForDone();
}

void JobQueue::push(Job job, Failure failure) {
    if (execution_ == Execution::inline_execution) {
        if (const Delivery delivery = delivery_of(job, failure)) delivery();
        return;
    }
    pool_.start(
        [this, work = std::move(job), failed = std::move(failure)] { post(delivery_of(work, failed)); });
}

void JobQueue::post(Delivery message) {
    if (!message) return;
    if (execution_ == Execution::inline_execution)
        message();
    else
        QMetaObject::invokeMethod(owner_, std::move(message), Qt::QueuedConnection);
}

}  // namespace covaria::ui
