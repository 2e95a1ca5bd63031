#include "ui/jobs/latest_job.h"

namespace covaria::ui {

LatestJob::LatestJob(Execution execution, Overtaken overtaken) : overtaken_(overtaken), jobs_(execution) {}

LatestJob::~LatestJob() {
    ++number_;
    stop_.request_stop();
}

void LatestJob::start(Job job, JobQueue::Failure failure) {
    awaited_ = true;
    const quint64 number = ++number_;
    jobs_.push(
        [this, job = std::move(job), number, stop = stop_.get_token()]() -> JobQueue::Delivery {
            if (number != number_ || stop.stop_requested()) return {};
            return [this, number, delivery = job(stop)] { deliver(number, delivery); };
        },
        [this, failure = std::move(failure), number](const Error& error) {
            deliver(number, [&] {
                if (failure) failure(error);
            });
        });
}

void LatestJob::deliver(quint64 number, const JobQueue::Delivery& delivery) {
    const bool newest = number == number_;
    if (number <= cancelled_ || (!newest && overtaken_ == Overtaken::dropped)) return;
    if (newest) awaited_ = false;
    if (delivery) delivery();
}

void LatestJob::cancel() {
    cancelled_ = number_;
    awaited_ = false;
    stop_.request_stop();
    stop_ = std::stop_source();
}

}  // namespace covaria::ui
