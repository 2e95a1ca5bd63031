// Exceptions of a job are told on the owner's thread; the queue goes on.
#include "ui/jobs/job_queue.h"

#include <gtest/gtest.h>

#include <QThread>
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "core/base/guarded.h"
#include "tests/ui/qt_application.h"

namespace covaria::ui::job_queue_test {

struct JobQueueTest : testing::TestWithParam<Execution> {
    void push(const JobQueue::Job& job) {
        queue.push(job, [this](const Error& error) {
            EXPECT_EQ(QThread::currentThread(), owner.thread());
            told.push_back(error.message.english());
        });
    }
    bool finished(std::size_t count) {
        return QTest::qWaitFor([&] { return told.size() == count; });
    }

    QObject owner;
    JobQueue queue{GetParam()};
    std::vector<std::string> told;
};

TEST_P(JobQueueTest, MemoryThatIsNotThereIsAnErrorAndTheNextJobRuns) {
    push([]() -> JobQueue::Delivery {
        const std::vector<double> all(std::numeric_limits<std::size_t>::max() / 16);
        return [size = all.size()] { EXPECT_EQ(size, 0u) << "so much memory was there"; };
    });
    push([]() -> JobQueue::Delivery { throw ImpossibleValue("width below zero"); });
    push([this]() -> JobQueue::Delivery { return [this] { told.emplace_back("done"); }; });
    ASSERT_TRUE(finished(3));
    EXPECT_EQ(told[0], "the memory of this machine does not suffice");
    EXPECT_EQ(told[1], "the values given lead to a width below zero");
    EXPECT_EQ(told[2], "done");
}

TEST(JobQueue, WhatIsNotDeliveredWhenItEndsIsDropped) {
    std::vector<int> told;
    {
        JobQueue queue(Execution::threads);
        for (int i = 0; i < 3; ++i)
            queue.push([&told, i]() -> JobQueue::Delivery { return [&told, i] { told.push_back(i); }; }, {});
        queue.wait();
    }
    QCoreApplication::processEvents();
    EXPECT_TRUE(told.empty());
}

TEST(JobQueue, MessagesOfAJobComeBeforeWhatItReturns) {
    std::vector<int> told;
    JobQueue queue(Execution::threads);
    queue.push(
        [&]() -> JobQueue::Delivery {
            for (int i = 0; i < 100; ++i) queue.post([&told, i] { told.push_back(i); });
            return [&] { told.push_back(100); };
        },
        {});
    ASSERT_TRUE(QTest::qWaitFor([&] { return told.size() == 101; }));
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
}

INSTANTIATE_TEST_SUITE_P(Both, JobQueueTest,
                         testing::Values(Execution::threads, Execution::inline_execution));

}  // namespace covaria::ui::job_queue_test
