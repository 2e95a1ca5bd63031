// Studies and designs in the worker thread: results, what becomes out of date, stopping.
#include <gtest/gtest.h>

#include "core/base/guarded.h"
#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "tests/ui/qt_application.h"
#include "ui/run/inquiries.h"

namespace covaria::ui::inquiry_runner_test {
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
    ProjectMaker maker(Execution::inline_execution);
    StudyRunner runner(study_inquiries(), maker, Execution::inline_execution);
    const ProjectSnapshot project = network();
    maker.request(project);
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::out_of_date);
    runner.run(analysis, sweep);
    ASSERT_TRUE(runner.status(analysis, sweep).is_current());
    EXPECT_EQ(runner.status(analysis, sweep).result->points.size(), 16u);
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::up_to_date);

    maker.request(changed(project, [](AnalysisEntry& entry) { entry.name = "another name"; }));
    EXPECT_TRUE(runner.status(analysis, sweep).is_current());
    maker.request(changed(project, [](AnalysisEntry& entry) { entry.studies[1].axes[0].values = 4; }));
    EXPECT_FALSE(runner.status(analysis, sweep).is_current());
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::out_of_date);
    EXPECT_TRUE(runner.status(analysis, sweep).result) << "the old result is kept";
    maker.request(project);
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::up_to_date) << "undone";
    maker.request(changed(project, [](AnalysisEntry& entry) { entry.studies.clear(); }));
    EXPECT_FALSE(runner.status(analysis, sweep).result);
}

TEST(DesignRunner, ResultIsOfTheDesignAndItsTargets) {
    ProjectMaker maker(Execution::inline_execution);
    DesignRunner runner(design_inquiries(), maker, Execution::inline_execution);
    const ProjectSnapshot project = changed(network(), [](AnalysisEntry& entry) {
        entry.designs[0].most_evaluations = 20;
        entry.designs[0].starts = 1;
        entry.designs[0].trials = 1000;
    });
    maker.request(project);
    const QString design = QStringLiteral("tracker-for-distances");
    runner.run(analysis, design);
    ASSERT_TRUE(runner.status(analysis, design).is_current());
    EXPECT_GT(runner.status(analysis, design).result->evaluations, 0u);
    maker.request(changed(project, [](AnalysisEntry& entry) { entry.designs[0].name = "another name"; }));
    EXPECT_TRUE(runner.status(analysis, design).is_current());
    maker.request(changed(project, [](AnalysisEntry& entry) { entry.designs[1].starts = 3; }));
    EXPECT_TRUE(runner.status(analysis, design).is_current()) << "another design";
    maker.request(changed(project, [](AnalysisEntry& entry) { entry.designs[0].starts = 3; }));
    EXPECT_FALSE(runner.status(analysis, design).is_current());
    maker.request(changed(project, [](AnalysisEntry& entry) {
        entry.requirements.push_back({"distances", "AB", Quantity{0.1, Unit::of("mm")}});
    }));
    EXPECT_FALSE(runner.status(analysis, design).is_current()) << "a design looks at targets";
    maker.request(project);
    EXPECT_TRUE(runner.status(analysis, design).is_current()) << "undone";
}

TEST(StudyRunner, FailureSaysWhy) {
    ProjectMaker maker(Execution::inline_execution);
    StudyRunner runner(study_inquiries(), maker, Execution::inline_execution);
    maker.request(
        changed(network(), [](AnalysisEntry& entry) { entry.studies[1].axes[0].target = "/setup/nothing"; }));
    runner.run(analysis, sweep);
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::failed);
    EXPECT_FALSE(runner.status(analysis, sweep).message.isEmpty());
}

TEST(StudyRunner, RunsTheStateThatIsBeingMade) {
    ProjectMaker maker(Execution::threads);
    StudyRunner runner(study_inquiries(), maker, Execution::threads);
    const ProjectSnapshot project = network();
    maker.make_now(project);
    maker.request(changed(project, [](AnalysisEntry& entry) { entry.studies[1].axes[0].values = 4; }));
    ASSERT_TRUE(maker.is_making());
    runner.run(analysis, sweep);
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::running);
    ASSERT_TRUE(runner.wait_until_idle(20'000));
    ASSERT_TRUE(runner.status(analysis, sweep).is_current());
    EXPECT_EQ(runner.status(analysis, sweep).result->points.size(), 4u);
}

TEST(StudyRunner, AStateThatCannotBeMadeFailsWhatWaitsForIt) {
    ProjectMaker maker(
        [](const MadeProject& made) -> Problems {
            if (made.project().title == "impossible") throw ImpossibleValue("width below zero");
            return {};
        },
        Execution::threads, nullptr);
    StudyRunner runner(study_inquiries(), maker, Execution::threads);
    const ProjectSnapshot project = network();
    maker.make_now(project);
    Project other = *project;
    other.title = "impossible";
    maker.request(std::make_shared<const Project>(other));
    runner.run(analysis, sweep);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !maker.is_making() && !runner.is_busy(); }));
    EXPECT_EQ(runner.status(analysis, sweep).state, RunState::failed);
    EXPECT_TRUE(runner.status(analysis, sweep).message.contains("width below zero"));
}

TEST(StudyRunner, StopsInTheWorkerThread) {
    ProjectMaker maker(Execution::inline_execution);
    StudyRunner runner(study_inquiries(), maker, Execution::threads);
    maker.request(changed(network(), [](AnalysisEntry& entry) {
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
}  // namespace covaria::ui::inquiry_runner_test
