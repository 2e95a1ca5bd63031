// The network of Galetto et al.: three targets, three cameras and a tracker (51 input, 12 output quantities),
// 10^6 trials with the linear GLS of the paper and with the joint non-linear estimator; first order, as after
// each move of a sensor; a network of 30 instruments and 1,000 targets (90,180 input, 3,000 output
// quantities).
#include <benchmark/benchmark.h>

#include "core/base/resource_path.h"
#include "core/project/project_file.h"
#include "core/project/workspace.h"
#include "core/propagation/engine.h"
#include "tests/bench/large_network.h"

namespace {

using namespace covaria;

const char* const analyses[] = {"paper", "recommended"};

std::shared_ptr<const PreparedAnalysis> prepared(std::size_t estimator) {
    const Project project = load_project(data_directory() / "projects/lsm-network.covaria").project;
    Problems problems;
    return prepare_analysis(project, analyses[estimator], make_assets(project, problems), problems);
}

void monte_carlo(benchmark::State& state) {
    const auto analysis = prepared(static_cast<std::size_t>(state.range(0)));
    RunControl control;
    control.threads = static_cast<int>(state.range(1));
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(*analysis->model, analysis->inputs, analysis->options, control));
    state.SetLabel(analyses[state.range(0)]);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(analysis->options.trials));
}
BENCHMARK(monte_carlo)
    ->Args({0, 1})
    ->Args({0, 2})
    ->Args({1, 1})
    ->Args({1, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// From the edited project to first-order results.
void first_order_after_an_edit(benchmark::State& state) {
    const Project project = load_project(data_directory() / "projects/lsm-network.covaria").project;
    for (auto _ : state) {
        Problems problems;
        const auto analysis =
            prepare_analysis(project, analyses[state.range(0)], make_assets(project, problems), problems);
        benchmark::DoNotOptimize(evaluate_first_order(*analysis->model, analysis->inputs, analysis->options));
    }
    state.SetLabel(analyses[state.range(0)]);
}
BENCHMARK(first_order_after_an_edit)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void first_order_of_a_large_network(benchmark::State& state) {
    const Project project =
        bench::large_network(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    for (auto _ : state) {
        Problems problems;
        const auto analysis =
            prepare_analysis(project, "recommended", make_assets(project, problems), problems);
        benchmark::DoNotOptimize(evaluate_first_order(*analysis->model, analysis->inputs, analysis->options));
    }
}
BENCHMARK(first_order_of_a_large_network)
    ->Args({4, 100})
    ->Args({30, 1000})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
