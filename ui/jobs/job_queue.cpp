// A thread pool of one thread.
#include "ui/jobs/job_queue.h"

#include <QMetaObject>

namespace covaria::ui {

JobQueue::JobQueue(QObject* owner, Execution execution) : owner_(owner), execution_(execution) {
    pool_.setMaxThreadCount(1);
}

JobQueue::~JobQueue() {
    pool_.waitForDone();
}

void JobQueue::push(Job job) {
    if (execution_ == Execution::inline_execution) {
        if (const Delivery delivery = job()) delivery();
        return;
    }
    pool_.start([this, work = std::move(job)] { post(work()); });
}

void JobQueue::post(Delivery message) {
    if (!message) return;
    if (execution_ == Execution::inline_execution)
        message();
    else
        QMetaObject::invokeMethod(owner_, std::move(message), Qt::QueuedConnection);
}

}  // namespace covaria::ui
