// A thread pool of one thread.
#include "ui/jobs/job_queue.h"

#include <QMetaObject>
#include <utility>

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

void Inbox::post(std::function<void()> message) {
    {
        const std::lock_guard lock(mutex_);
        messages_.push_back(std::move(message));
    }
    QMetaObject::invokeMethod(this, "take", Qt::QueuedConnection);
}

void Inbox::take() {
    std::function<void()> message;
    {
        const std::lock_guard lock(mutex_);
        message = std::move(messages_.front());
        messages_.pop_front();
    }
    message();
}

JobQueue::JobQueue(Execution execution) : execution_(execution) {
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
        inbox_.post(std::move(message));
}

}  // namespace covaria::ui
