// The runner over the real engine: an edit of an example becomes first-order results, then Monte Carlo.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/kinds/registries.h"
#include "core/made/load_project.h"
#include "tests/ui/qt_application.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui::live_edit_test {
namespace {

Project example(const ModelDescriptor& model) {
    const auto file = std::filesystem::path(COVARIA_SOURCE_DIR) / "projects" / model.example;
    LoadedProject loaded = load_project(file);
    EXPECT_FALSE(loaded.problems.has_errors()) << file;
    for (AnalysisEntry& analysis : loaded.project.analyses) {
        analysis.options.method = Method::monte_carlo;
        analysis.options.trials = 4'000;  // the thread sanitizer takes a hundredfold
        analysis.options.one_at_a_time_trials = 0;
    }
    return loaded.project;
}

TEST(LiveEdit, EveryExampleRunsAndFollowsAnEdit) {
    ASSERT_FALSE(model_registry().empty());
    for (const ModelDescriptor& model : model_registry()) {
        Project project = example(model);
        ASSERT_FALSE(project.analyses.empty()) << model.id;
        const QString id = QString::fromStdString(project.analyses.front().id);
        ProjectMaker maker;
        AnalysisRunner runner(maker);
        runner.set_live(true);
        std::vector<ResultStage> stages;
        QObject::connect(&runner, &AnalysisRunner::result_changed, &runner, [&](const QString& changed) {
            if (changed == id) stages.push_back(runner.status(id).stage);
        });
        maker.request(std::make_shared<const Project>(project));
        ASSERT_TRUE(runner.wait_until_idle(300'000)) << model.id;
        ASSERT_EQ(runner.status(id).state, RunState::up_to_date)
            << model.id << ": " << runner.status(id).message.toStdString();
        EXPECT_EQ(stages, (std::vector{ResultStage::first_order, ResultStage::complete})) << model.id;

        const auto seed_1 = runner.status(id).result;
        for (AnalysisEntry& analysis : project.analyses) ++analysis.options.seed;
        maker.request(std::make_shared<const Project>(project));
        ASSERT_TRUE(runner.wait_until_idle(300'000)) << model.id;
        const auto seed_2 = runner.status(id).result;
        EXPECT_TRUE(runner.status(id).is_current());
        EXPECT_EQ(seed_1->outputs[0].first_order.standard_uncertainty,
                  seed_2->outputs[0].first_order.standard_uncertainty);
        // U is compared, since u is infinite for Student t inputs with two degrees of freedom.
        EXPECT_NE(seed_1->outputs[0].expanded_uncertainty, seed_2->outputs[0].expanded_uncertainty);
    }
}

}  // namespace
}  // namespace covaria::ui::live_edit_test
