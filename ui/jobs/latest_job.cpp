#include "ui/jobs/latest_job.h"

namespace covaria::ui {

LatestJob::LatestJob(QObject* owner, Execution execution, Overtaken overtaken)
    : overtaken_(overtaken), jobs_(owner, execution) {}

LatestJob::~LatestJob() {
    ++number_;
    stop_.request_stop();
}

void LatestJob::start(Job job) {
    awaited_ = true;
    jobs_.push(
        [this, job = std::move(job), number = ++number_, stop = stop_.get_token()]() -> JobQueue::Delivery {
            if (number != number_ || stop.stop_requested()) return {};
            return [this, number, delivery = job(stop)] {
                const bool newest = number == number_;
                if (number <= cancelled_ || (!newest && overtaken_ == Overtaken::dropped)) return;
                if (newest) awaited_ = false;
                if (delivery) delivery();
            };
        });
}

void LatestJob::cancel() {
    cancelled_ = number_;
    awaited_ = false;
    stop_.request_stop();
    stop_ = std::stop_source();
}

}  // namespace covaria::ui
