// The procedure of Brosed et al.: 22 points, 3 ballbars, a robot (135 input, 76 output quantities), 10^6
// trials; the model alone, without draws and statistics; first order, as after each edit.
#include <benchmark/benchmark.h>

#include "core/base/resource_path.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace {

using namespace covaria;

Project example() {
    return load_project(data_directory() / "projects/ballbar-tcp.covaria").project;
}

std::shared_ptr<const PreparedAnalysis> prepared(const Project& project) {
    Problems problems;
    return made_analysis(project, "paper", problems);
}

void monte_carlo(benchmark::State& state) {
    const auto analysis = prepared(example());
    EvaluationOptions options = analysis->options;
    options.contributor_trials = state.range(1) == 0 ? 0 : options.trials;
    RunControl control;
    control.threads = static_cast<int>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(*analysis->model, analysis->inputs, options, control));
    state.SetLabel(state.range(1) == 0 ? "full result" : "full result, ideal robot, ideal ballbars");
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(options.trials));
}
BENCHMARK(monte_carlo)
    ->Args({1, 0})
    ->Args({2, 0})
    ->Args({2, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Computes first-order results of the edited project.
void first_order_after_an_edit(benchmark::State& state) {
    const Project project = example();
    for (auto _ : state) {
        const auto analysis = prepared(project);
        benchmark::DoNotOptimize(evaluate_first_order(*analysis->model, analysis->inputs, analysis->options));
    }
}
BENCHMARK(first_order_after_an_edit)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
