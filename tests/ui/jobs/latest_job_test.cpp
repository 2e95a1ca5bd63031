// A LatestJob delivers only the newest of works that follow each other, or every step where that is wanted.
#include "ui/jobs/latest_job.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/guarded.h"
#include "tests/ui/qt_application.h"

namespace covaria::ui::latest_job_test {
namespace {

/// Opened once; a job that waits at it has begun and not ended.
class Gate {
public:
    void open() {
        const std::lock_guard lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }
    void pass() {
        std::unique_lock lock(mutex_);
        waits_ = true;
        changed_.notify_all();
        changed_.wait(lock, [&] { return open_; });
    }
    void wait_for_somebody() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return waits_; });
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool open_ = false, waits_ = false;
};

struct LatestJobTest : testing::Test {
    ~LatestJobTest() override { gate.open(); }  // whatever waits there ends before the queue does
    void start(LatestJob& job, const std::string& name) {
        job.start(
            [this, name](const std::stop_token&) -> JobQueue::Delivery {
                return [this, name] { told.push_back(name); };
            },
            [this](const Error& error) { told.push_back(error.message.english()); });
    }
    void start_at_gate(LatestJob& job, const std::string& name) {
        job.start(
            [this, name](const std::stop_token&) -> JobQueue::Delivery {
                gate.pass();
                return [this, name] { told.push_back(name); };
            },
            [](const Error&) {});
        gate.wait_for_somebody();
    }
    void wait_for(const LatestJob& job) {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !job.is_busy(); }));
    }

    Gate gate;
    std::vector<std::string> told;
};

TEST_F(LatestJobTest, OnlyTheNewestIsDelivered) {
    LatestJob job(Execution::threads);
    start_at_gate(job, "first");
    start(job, "second");
    start(job, "third");
    gate.open();
    wait_for(job);
    EXPECT_EQ(told, std::vector<std::string>{"third"});
}

TEST_F(LatestJobTest, StepsThatRanAreDeliveredWhereTheyAreWorthSeeing) {
    LatestJob job(Execution::threads, LatestJob::Overtaken::delivered);
    start_at_gate(job, "first");
    start(job, "second");
    start(job, "third");
    gate.open();
    wait_for(job);
    EXPECT_EQ(told, (std::vector<std::string>{"first", "third"})) << "the second gave way while it waited";
}

TEST_F(LatestJobTest, ACancelledJobIsAskedToStopAndNeverDelivered) {
    for (const auto overtaken : {LatestJob::Overtaken::dropped, LatestJob::Overtaken::delivered}) {
        told.clear();
        Gate own;
        LatestJob job(Execution::threads, overtaken);
        bool asked = false;
        job.start(
            [&](const std::stop_token& stop) -> JobQueue::Delivery {
                own.pass();
                asked = stop.stop_requested();
                return [this] { told.push_back("cancelled"); };
            },
            [](const Error&) {});
        own.wait_for_somebody();
        job.cancel();
        EXPECT_FALSE(job.is_busy());
        start(job, "next");
        own.open();
        wait_for(job);
        EXPECT_TRUE(asked);
        EXPECT_EQ(told, std::vector<std::string>{"next"});
    }
}

TEST_F(LatestJobTest, AFailureIsToldAndTheNextJobRuns) {
    for (const auto execution : {Execution::threads, Execution::inline_execution}) {
        told.clear();
        LatestJob job(execution);
        job.start(
            [](const std::stop_token&) -> JobQueue::Delivery { throw ImpossibleValue("width below zero"); },
            [this](const Error& error) { told.push_back(error.message.english()); });
        wait_for(job);
        start(job, "next");
        wait_for(job);
        EXPECT_EQ(told, (std::vector<std::string>{"the values given lead to a width below zero", "next"}));
    }
}

TEST_F(LatestJobTest, AFailureThatHasBeenOvertakenIsNotTold) {
    LatestJob job(Execution::threads);
    job.start(
        [this](const std::stop_token&) -> JobQueue::Delivery {
            gate.pass();
            throw ImpossibleValue("width below zero");
        },
        [this](const Error& error) { told.push_back(error.message.english()); });
    gate.wait_for_somebody();
    start(job, "next");
    gate.open();
    wait_for(job);
    EXPECT_EQ(told, std::vector<std::string>{"next"});
}

}  // namespace
}  // namespace covaria::ui::latest_job_test
