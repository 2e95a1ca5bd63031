// JCGM 101 9.2, 9.4 and 9.5 as typed equations: 10^6 trials with coverage intervals; the equations alone; an
// implicit equation.
#include <benchmark/benchmark.h>

#include "core/base/resource_path.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace {

using namespace covaria;

std::shared_ptr<const PreparedAnalysis> prepared(const std::string& file, const std::string& analysis) {
    const Project project = load_project(data_directory() / "projects/gum" / file).project;
    Problems problems;
    return made_analysis(project, analysis, problems);
}

void monte_carlo(benchmark::State& state, const std::string& file, const std::string& analysis) {
    const auto of = prepared(file, analysis);
    EvaluationOptions options = of->options;
    options.method = Method::monte_carlo;
    options.trials = 1'000'000;
    options.second_order = false;
    RunControl control;
    control.threads = static_cast<int>(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(evaluate(*of->model, of->inputs, options, control));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(options.trials));
}
BENCHMARK_CAPTURE(monte_carlo, jcgm_101_9_2_normal, "s1-9.2-additive.covaria", "normal")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(monte_carlo, jcgm_101_9_2_rectangular, "s1-9.2-additive.covaria", "rectangular")
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(monte_carlo, jcgm_101_9_4, "s1-9.4-power-meter.covaria", "x010-r9")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(monte_carlo, jcgm_101_9_5, "s1-9.5-gauge-block.covaria", "gauge-block")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The model alone, trial by trial: what the engine asks of it.
void equations_alone(benchmark::State& state) {
    const auto of = prepared("s1-9.5-gauge-block.covaria", "gauge-block");
    constexpr std::size_t trials = 1000;
    std::vector<double> numbers(64 + (of->inputs.quantities.size() + 1) * trials);
    double* x = numbers.data();
    while (reinterpret_cast<std::uintptr_t>(x) % 64 != 0) ++x;
    for (std::size_t i = 0; i < of->inputs.quantities.size(); ++i)
        std::fill_n(x + i * trials, trials, estimate_of(of->inputs, i));
    std::vector<std::uint8_t> valid(trials);
    double* y = x + of->inputs.quantities.size() * trials;
    for (auto _ : state) {
        of->model->evaluate_block({x, y, valid.data(), trials, trials});
        benchmark::DoNotOptimize(y[0]);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(trials));
}
BENCHMARK(equations_alone);

}  // namespace

BENCHMARK_MAIN();
