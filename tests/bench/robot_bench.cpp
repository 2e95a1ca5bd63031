// The robot of Wen et al.: 10^6 trials of one pose; maps of 1,000 poses, first order and with 10^5 trials
// each; trials of the identification by joint trajectories (900 input quantities).
#include <benchmark/benchmark.h>

#include "core/base/resource_path.h"
#include "core/propagation/engine.h"
#include "core/study/study.h"
#include "tests/core/made.h"

namespace {

using namespace covaria;

Project robot_project() {
    return load_project(data_directory() / "projects/er10l-c10.covaria").project;
}

void trials_of(benchmark::State& state, const char* id) {
    const Project project = robot_project();
    Problems problems;
    const auto analysis = made_analysis(project, id, problems);
    RunControl control;
    control.threads = static_cast<int>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(*analysis->model, analysis->inputs, analysis->options, control));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(analysis->options.trials));
}

void one_pose(benchmark::State& state) {
    trials_of(state, "zero-pose");
}
void joint_trajectories(benchmark::State& state) {
    trials_of(state, "trajectories-simulated");
}

void map(benchmark::State& state, Method method) {
    Project project = robot_project();
    for (AnalysisEntry& analysis : project.analyses) {
        if (analysis.id != "zero-pose") continue;
        for (StudyAxis& axis : analysis.studies.front().axes) axis.values = 10;
        analysis.studies.front().method = method;
    }
    Problems problems;
    const auto study = prepare_study(MadeProject::make(project), "zero-pose", "workspace", problems);
    if (!study) return state.SkipWithError("the study cannot be prepared");
    RunControl control;
    control.threads = static_cast<int>(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(run_study(*study, control));
    state.SetItemsProcessed(state.iterations() * 1000);
}
void map_first_order(benchmark::State& state) {
    map(state, Method::first_order);
}
void map_trials(benchmark::State& state) {
    map(state, Method::monte_carlo);
}

BENCHMARK(one_pose)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(joint_trajectories)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(map_first_order)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(map_trials)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
