// Studies in the worker thread: results, what becomes out of date, stopping.
#include <gtest/gtest.h>

#include "core/base/resource_path.h"
#include "core/project/project_file.h"
#include "ui/run/study_runner.h"

namespace covaria::ui::study_runner_test {
namespace {

ProjectSnapshot network() {
    return std::make_shared<const Project>(
        load_project(data_directory() / "projects/lsm-network.covaria").project);
}

ProjectSnapshot changed(const ProjectSnapshot& project, const std::function<void(AnalysisEntry&)>& edit) {
    Project copy = *project;
    for (AnalysisEntry& analysis : copy.analyses)
        if (analysis.id == "recommended") edit(analysis);
    return std::make_shared<const Project>(std::move(copy));
}

const QString analysis = QStringLiteral("recommended"), sweep = QStringLiteral("station-angle");

TEST(StudyRunner, ResultIsCurrentUntilSomethingThatMattersChanges) {
    StudyRunner runner(Execution::inline_execution);
    const ProjectSnapshot project = network();
    runner.set_project(project);
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::out_of_date);
    runner.run(analysis, sweep);
    ASSERT_TRUE(runner.status(analysis, sweep).is_current());
    EXPECT_EQ(runner.status(analysis, sweep).result->points.size(), 16u);
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::up_to_date);

    runner.set_project(changed(project, [](AnalysisEntry& entry) { entry.name = "another name"; }));
    EXPECT_TRUE(runner.status(analysis, sweep).is_current());
    runner.set_project(changed(project, [](AnalysisEntry& entry) { entry.studies[1].axes[0].values = 4; }));
    EXPECT_FALSE(runner.status(analysis, sweep).is_current());
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::out_of_date);
    EXPECT_TRUE(runner.status(analysis, sweep).result) << "the old result is kept";
    runner.set_project(project);
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::up_to_date) << "undone";
    runner.set_project(changed(project, [](AnalysisEntry& entry) { entry.studies.clear(); }));
    EXPECT_FALSE(runner.status(analysis, sweep).result);
}

TEST(StudyRunner, FailureSaysWhy) {
    StudyRunner runner(Execution::inline_execution);
    runner.set_project(
        changed(network(), [](AnalysisEntry& entry) { entry.studies[1].axes[0].target = "/setup/nothing"; }));
    runner.run(analysis, sweep);
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::failed);
    EXPECT_FALSE(runner.status(analysis, sweep).message.isEmpty());
}

TEST(StudyRunner, StopsInTheWorkerThread) {
    StudyRunner runner(Execution::threads);
    runner.set_project(changed(network(), [](AnalysisEntry& entry) {
        entry.studies[1].method = Method::monte_carlo;
        entry.studies[1].trials = 1'000'000'000;
    }));
    runner.run(analysis, sweep);
    EXPECT_TRUE(runner.is_busy());
    runner.stop_all();
    EXPECT_TRUE(runner.wait_until_idle(20'000));
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::out_of_date);
    EXPECT_FALSE(runner.status(analysis, sweep).result);
}

}  // namespace
}  // namespace covaria::ui::study_runner_test
