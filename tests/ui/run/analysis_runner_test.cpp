// Runs, stopping, latest wins, live mode: with a scripted backend.
#include "ui/run/analysis_runner.h"
#include "ui/run/result_words.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <new>
#include <stop_token>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "core/text/numbers.h"
#include "tests/ui/qt_application.h"
#include "ui/theme/strings.h"

namespace covaria::ui::analysis_runner_test {
namespace {

constexpr std::uint64_t bad = 1000;     ///< cannot be made
constexpr std::uint64_t fails = 1001;   ///< cannot be run
constexpr std::uint64_t huge = 1002;    ///< there is no memory to make it
constexpr std::uint64_t greedy = 1003;  ///< there is no memory to run it

/// A door that runs wait at while it is closed, or until they are stopped.
class Gate {
public:
    void operator=(bool closed) {
        {
            const std::lock_guard lock(mutex_);
            closed_ = closed;
        }
        opened_.notify_all();
    }
    void pass(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        opened_.wait(lock, stop, [this] { return !closed_; });
    }

private:
    std::mutex mutex_;
    std::condition_variable_any opened_;
    bool closed_ = false;
};

/// The number that a project is about is the seed of all its analyses; see `project`.
struct Script {
    Gate block;  ///< holds full runs back
    std::atomic<int> runs = 0;
    std::atomic<int> first_orders = 0;
    std::atomic<int> runs_of_x = 0;
    std::atomic<double> gain = 1.0;  ///< gain of runs with variance reduction

    RunBackend backend() {
        return {[this](const PreparedAnalysis&) {
                    ++first_orders;
                    return Result<UncertaintyResult>(UncertaintyResult{});
                },
                [this](const PreparedAnalysis& analysis, const RunControl& control) {
                    return full(analysis, control);
                }};
    }
    Result<UncertaintyResult> full(const PreparedAnalysis& analysis, const RunControl& control) {
        ++runs;
        if (analysis.id == "x") ++runs_of_x;
        if (control.progress) control.progress({500, 1000});
        block.pass(control.stop);
        if (control.stop.stop_requested()) return fail(ErrorCode::cancelled, "stopped");
        if (analysis.options.seed == greedy) throw std::bad_alloc();
        if (analysis.options.seed == fails) return fail(ErrorCode::numeric, "no value at the estimates");
        UncertaintyResult result;
        result.trials = analysis.options.trials;
        result.provenance.seed = analysis.options.seed;
        result.variance_reduction = analysis.options.variance_reduction;
        if (result.variance_reduction != VarianceReduction::none) {
            ReducedVariance reduced;
            reduced.gains = {gain, gain, gain, gain};
            result.outputs.emplace_back().monte_carlo.emplace().reduced = reduced;
        }
        return result;
    }
};

/// Analyses of a smallest model with this seed.
ProjectSnapshot project(std::uint64_t seed, std::vector<std::string> ids = {"x"}) {
    static const Project start =
        load_project(data_directory() / "resources/verification/distributions.covaria").project;
    Project value;
    for (const std::string& id : ids) {
        AnalysisEntry& entry = value.analyses.emplace_back(start.analyses.front());
        entry.id = entry.name = id;
        entry.options = {};
        entry.options.seed = seed;
        if (seed == bad) entry.model = "none";
    }
    return std::make_shared<const Project>(value);
}

Problems check(const MadeProject& made) {
    for (const AnalysisEntry& analysis : made.project().analyses)
        if (analysis.options.seed == huge) throw std::bad_alloc();
    return made.problems();
}

struct AnalysisRunnerTest : testing::Test {
    const AnalysisStatus& status(const char* id = "x") { return runner.status(id); }
    bool settle() { return runner.wait_until_idle(5000); }
    Script script;
    ProjectMaker maker{check, Execution::threads, nullptr};
    AnalysisRunner runner{maker, script.backend(), Execution::threads};
};

TEST_F(AnalysisRunnerTest, RunsAndBecomesUpToDate) {
    maker.request(project(1));
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::out_of_date);
    EXPECT_FALSE(status().result);
    runner.run("x");
    EXPECT_EQ(status().state, RunState::running);
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::up_to_date);
    EXPECT_EQ(status().stage, ResultStage::complete);
    EXPECT_TRUE(status().is_current());
}

TEST_F(AnalysisRunnerTest, ARunAskedForBeforeThePreparationIsNotLost) {
    maker.request(project(1));
    runner.run("x");
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::up_to_date);
}

TEST_F(AnalysisRunnerTest, AChangeMakesTheResultOutOfDateAndUndoingItCurrentAgain) {
    maker.request(project(1));
    runner.run("x");
    ASSERT_TRUE(settle());
    maker.request(project(2));
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::out_of_date);
    EXPECT_TRUE(status().result) << "still there to be seen, marked as old";
    EXPECT_FALSE(status().is_current());
    maker.request(project(1));
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::up_to_date);
}

TEST_F(AnalysisRunnerTest, StopsARun) {
    script.block = true;
    maker.request(project(1));
    runner.run("x");
    ASSERT_TRUE(QTest::qWaitFor([&] { return script.runs == 1; }));
    runner.stop("x");
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::out_of_date);
    EXPECT_FALSE(status().result);
    EXPECT_TRUE(status().message.isEmpty()) << "stopping is not a failure";
}

TEST_F(AnalysisRunnerTest, MemoryThatIsNotThereIsAFailureLikeAnother) {
    for (const std::uint64_t seed : {huge, greedy}) {
        maker.request(project(seed));
        runner.run("x");
        ASSERT_TRUE(settle());
        EXPECT_EQ(status().state, RunState::failed) << seed;
        EXPECT_EQ(status().message, "the memory of this machine does not suffice");
        EXPECT_FALSE(status().is_current());
    }
    maker.request(project(1));
    runner.run("x");
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::up_to_date) << "the workers are still there";
}

TEST_F(AnalysisRunnerTest, FailuresSayWhy) {
    maker.request(project(fails));
    runner.run("x");
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::failed);
    EXPECT_EQ(status().message, "no value at the estimates");
    maker.request(project(bad));
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::failed);
    EXPECT_TRUE(status().message.contains("there is no measurement model 'none'"));
    maker.request(project(7));
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::out_of_date);
    EXPECT_TRUE(status().message.isEmpty());
}

TEST_F(AnalysisRunnerTest, ReportsProgress) {
    QSignalSpy progress(&runner, &AnalysisRunner::progress_changed);
    maker.request(project(1));
    runner.run("x");
    ASSERT_TRUE(settle());
    ASSERT_EQ(progress.count(), 1);
    EXPECT_EQ(progress[0][0].toString(), "x");
    EXPECT_EQ(progress[0][1].value<RunProgress>().trials_done, 500u);
}

TEST_F(AnalysisRunnerTest, LiveModeShowsFirstOrderBeforeMonteCarlo) {
    maker.request(project(1));
    ASSERT_TRUE(settle());
    runner.set_live(true);
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::up_to_date);
    std::vector<ResultStage> stages;
    QObject::connect(&runner, &AnalysisRunner::result_changed, &runner,
                     [&] { stages.push_back(status().stage); });
    maker.request(project(2));
    ASSERT_TRUE(settle());
    EXPECT_EQ(stages, (std::vector{ResultStage::first_order, ResultStage::preview, ResultStage::complete}));
    EXPECT_EQ(script.first_orders, 1);
    EXPECT_EQ(status().result->trials, EvaluationOptions{}.trials);
    EXPECT_EQ(status().result->variance_reduction, VarianceReduction::none) << "the preview's only";
}

TEST_F(AnalysisRunnerTest, APreviewSaysWhatItIsWorth) {
    script.gain = 234.0;
    maker.request(project(1));
    runner.set_live(true);
    std::vector<QString> words;
    std::vector<VarianceReduction> reductions;
    QObject::connect(&runner, &AnalysisRunner::result_changed, &runner, [&] {
        if (status().stage != ResultStage::preview) return;
        words.push_back(result_words(status()));
        reductions.push_back(status().result->variance_reduction);
    });
    ASSERT_TRUE(settle());
    script.gain = 1.2;
    maker.request(project(2));
    ASSERT_TRUE(settle());
    script.gain = 1e12;
    maker.request(project(3));
    ASSERT_TRUE(settle());
    const auto count = [](std::uint64_t trials) { return to_qt(count_text(trials)); };
    const QString words_of_plain =
        QStringLiteral("Preview with %1 of %2 trials").arg(count(12'000), count(1'000'000));
    EXPECT_EQ(words, (std::vector{words_of_plain + QStringLiteral(", as good as ") + count(2'000'000) +
                                      QStringLiteral(" plain trials"),
                                  words_of_plain,
                                  words_of_plain + QStringLiteral(", as good as ") + count(1'000'000'000) +
                                      QStringLiteral(" plain trials")}));
    EXPECT_EQ(reductions, std::vector(3, VarianceReduction::control_variate));
}

TEST_F(AnalysisRunnerTest, InLiveModeTheLatestChangeWins) {
    runner.set_live(true);
    script.block = true;
    maker.request(project(8));
    ASSERT_TRUE(QTest::qWaitFor([&] { return script.runs >= 1; }));
    QSignalSpy results(&runner, &AnalysisRunner::result_changed);
    for (int i = 0; i < 100; ++i) maker.request(project(100 + std::uint64_t(i)));
    ASSERT_TRUE(QTest::qWaitFor([&] { return status().prepared && status().prepared->options.seed == 199; }));
    script.block = false;
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::up_to_date);
    EXPECT_EQ(status().result->provenance.seed, 199u);
    EXPECT_GT(results.count(), 0);
    EXPECT_LT(script.runs, 100) << "most changes are skipped, not queued";
}

TEST_F(AnalysisRunnerTest, AStaleRunNeverReplacesACurrentResult) {
    maker.request(project(1));
    runner.run("x");
    ASSERT_TRUE(settle());
    maker.request(project(2));
    ASSERT_TRUE(settle());
    script.block = true;
    runner.run("x");
    ASSERT_TRUE(QTest::qWaitFor([&] { return script.runs == 2; }));
    maker.request(project(1));
    ASSERT_TRUE(QTest::qWaitFor([&] { return status().state == RunState::up_to_date; }));
    script.block = false;  // the run of "2" ends now
    ASSERT_TRUE(settle());
    EXPECT_EQ(status().state, RunState::up_to_date);
    EXPECT_EQ(status().result->provenance.seed, 1u);
}

TEST_F(AnalysisRunnerTest, TheAnalysisInFocusComesFirst) {
    QStringList order;
    QObject::connect(&runner, &AnalysisRunner::result_changed, &runner,
                     [&](const QString& id) { order << id; });
    maker.request(project(1, {"a", "b", "c"}));
    ASSERT_TRUE(settle());
    runner.set_focus("c");
    runner.run_all();
    ASSERT_TRUE(settle());
    EXPECT_EQ(order.size(), 3);
    EXPECT_EQ(runner.status("a").state, RunState::up_to_date);
    EXPECT_EQ(order.first(), "c");
}

TEST_F(AnalysisRunnerTest, StopAllEmptiesTheQueue) {
    script.block = true;
    maker.request(project(1, {"a", "b", "c"}));
    ASSERT_TRUE(settle());
    runner.run_all();
    ASSERT_TRUE(QTest::qWaitFor([&] { return script.runs == 1; }));
    runner.stop_all();
    ASSERT_TRUE(settle());
    EXPECT_EQ(script.runs, 1);
    for (const char* id : {"a", "b", "c"}) EXPECT_EQ(status(id).state, RunState::out_of_date);
}

TEST_F(AnalysisRunnerTest, RemovedAnalysesAreForgotten) {
    maker.request(project(1, {"a", "b"}));
    runner.run_all();
    ASSERT_TRUE(settle());
    maker.request(project(1, {"b"}));
    ASSERT_TRUE(settle());
    EXPECT_FALSE(runner.status("a").result);
    EXPECT_EQ(runner.status("b").state, RunState::up_to_date);
    maker.forget();
    maker.request(project(1, {"b"}));
    ASSERT_TRUE(settle());
    EXPECT_EQ(runner.status("b").state, RunState::out_of_date);
}

TEST_F(AnalysisRunnerTest, CanBeDestroyedWhileRunning) {
    script.block = true;
    auto other = std::make_unique<AnalysisRunner>(maker, script.backend(), Execution::threads);
    maker.request(project(1));
    other->run("x");
    ASSERT_TRUE(QTest::qWaitFor([&] { return script.runs == 1; }));
    other.reset();
    QCoreApplication::processEvents();
}

TEST(AnalysisRunnerInline, EverythingHappensAtOnce) {
    Script script;
    ProjectMaker maker(Execution::inline_execution);
    AnalysisRunner runner(maker, script.backend(), Execution::inline_execution);
    runner.set_live(true);
    maker.request(project(1, {"a", "b"}));
    EXPECT_EQ(runner.status("a").state, RunState::up_to_date);
    EXPECT_EQ(runner.status("b").state, RunState::up_to_date);
    EXPECT_FALSE(runner.is_busy());
}

TEST_F(AnalysisRunnerTest, WhatIsHeldDoesNotRunAndHasNoCurrentResult) {
    maker.request(project(1, {"x", "y"}));
    ASSERT_TRUE(settle());
    runner.run_all();
    ASSERT_TRUE(settle());
    ASSERT_TRUE(status().is_current());
    const int runs = script.runs, runs_of_x = script.runs_of_x;
    runner.set_held({{"x", "12 kg is no length"}});
    EXPECT_EQ(status().state, RunState::failed);
    EXPECT_EQ(status().message, "12 kg is no length");
    EXPECT_FALSE(status().is_current());
    EXPECT_TRUE(status("y").is_current());
    runner.run("x");
    runner.run_all();
    maker.request(project(2, {"x", "y"}));
    runner.set_live(true);
    ASSERT_TRUE(settle());
    EXPECT_EQ(script.runs_of_x, runs_of_x);
    EXPECT_GT(script.runs, runs) << "of the other one";
    EXPECT_TRUE(status("y").is_current());
    EXPECT_EQ(status().state, RunState::failed);
    runner.set_held({});
    ASSERT_TRUE(settle());
    EXPECT_TRUE(status().is_current()) << "live again";
}

}  // namespace
}  // namespace covaria::ui::analysis_runner_test
