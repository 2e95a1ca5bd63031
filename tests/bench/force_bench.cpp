// Kim's six-axis sensor: three cases decoupled by the calibration matrix (54 input, 36 output quantities,
// 10^6 trials), the same with quadratic terms, the six channels with interference (12 input, 18 output
// quantities), and first order from the edited project, its 252 readings evaluated anew.
#include <benchmark/benchmark.h>

#include "core/base/resource_path.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace {

using namespace covaria;

Project example(bool quadratic = false) {
    Project project = load_project(data_directory() / "projects/force-moment-sensor.covaria").project;
    for (AnalysisEntry& entry : project.analyses)
        if (quadratic && entry.id == "loads") entry.setup.values["matrix"] = std::string("quadratic");
    return project;
}

std::shared_ptr<const PreparedAnalysis> prepared(const Project& project, const char* id) {
    Problems problems;
    return made_analysis(project, id, problems);
}

struct Job {
    const char* analysis;
    bool quadratic;
    const char* label;
};
constexpr Job jobs[] = {{"combined", false, "channels"},
                        {"loads", false, "calibration matrix"},
                        {"loads", true, "calibration matrix, quadratic"}};

void monte_carlo(benchmark::State& state) {
    const Job& job = jobs[state.range(1)];
    const auto analysis = prepared(example(job.quadratic), job.analysis);
    EvaluationOptions options = analysis->options;
    options.method = Method::monte_carlo;
    options.trials = 1'000'000;
    options.contributor_trials = 0;
    RunControl control;
    control.threads = static_cast<int>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(*analysis->model, analysis->inputs, options, control));
    state.SetLabel(job.label);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(options.trials));
}
BENCHMARK(monte_carlo)->ArgsProduct({{1, 2}, {0, 1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

void first_order_after_an_edit(benchmark::State& state) {
    const Project project = example();
    for (auto _ : state) {
        const auto analysis = prepared(project, "loads");
        benchmark::DoNotOptimize(evaluate_first_order(*analysis->model, analysis->inputs, analysis->options));
    }
}
BENCHMARK(first_order_after_an_edit)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
