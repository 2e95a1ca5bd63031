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

JobQueue::JobQueue(Execution execution) : execution_(execution) {}

JobQueue::~JobQueue() {
    if (!worker_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_all();
    worker_.join();
}

void JobQueue::push(Job job, Failure failure) {
    if (execution_ == Execution::inline_execution) {
        if (const Delivery delivery = delivery_of(job, failure)) delivery();
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        jobs_.emplace_back(
            [this, work = std::move(job), failed = std::move(failure)] { post(delivery_of(work, failed)); });
    }
    changed_.notify_all();
    if (!worker_.joinable()) worker_ = std::thread([this] { work(); });
}

void JobQueue::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return ending_ || !jobs_.empty(); });
        if (jobs_.empty()) return;
        std::function<void()> job = std::move(jobs_.front());
        lock.unlock();
        job();
        job = nullptr;  // frees what it holds before it counts as done
        lock.lock();
        jobs_.pop_front();
        changed_.notify_all();
    }
}

void JobQueue::wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return jobs_.empty(); });
}

void JobQueue::post(Delivery message) {
    if (!message) return;
    if (execution_ == Execution::inline_execution)
        message();
    else
        inbox_.post(std::move(message));
}

}  // namespace covaria::ui
