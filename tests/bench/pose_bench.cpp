// The Stewart platform: 13 poses (126 input, 78 output quantities) with 10^6 trials, its first order, one
// pose, and the equations alone.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "core/base/resource_path.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace {

using namespace covaria;

std::shared_ptr<const PreparedAnalysis> prepared(std::size_t poses) {
    Project project = load_project(data_directory() / "projects/stewart-platform.covaria").project;
    auto& table = std::get<SetupTable>(project.analyses.at(0).setup.values.at("poses"));
    table.rows.resize(poses);
    Problems problems;
    return made_analysis(project, "printed", problems);
}

void monte_carlo(benchmark::State& state) {
    const auto analysis = prepared(static_cast<std::size_t>(state.range(0)));
    RunControl control;
    control.threads = static_cast<int>(state.range(1));
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(*analysis->model, analysis->inputs, analysis->options, control));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(analysis->options.trials));
}
BENCHMARK(monte_carlo)
    ->Args({13, 1})
    ->Args({13, 2})
    ->Args({1, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void first_order(benchmark::State& state) {
    const auto analysis = prepared(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate_first_order(*analysis->model, analysis->inputs, analysis->options));
}
BENCHMARK(first_order)->Arg(13)->Arg(1)->Unit(benchmark::kMillisecond);

void jacobian(benchmark::State& state) {
    const auto analysis = prepared(13);
    std::vector<double> x;
    for (std::size_t i = 0; i < analysis->inputs.quantities.size(); ++i)
        x.push_back(estimate_of(analysis->inputs, i));
    Eigen::MatrixXd j;
    for (auto _ : state) benchmark::DoNotOptimize(analysis->model->jacobian(x, j));
}
BENCHMARK(jacobian)->Unit(benchmark::kMicrosecond);

// 10^6 trials of the equations, without draws and statistics.
void equations(benchmark::State& state) {
    const auto analysis = prepared(static_cast<std::size_t>(state.range(0)));
    constexpr std::size_t trials = 1024;
    const std::size_t n = analysis->inputs.quantities.size(), m = analysis->model->outputs().size();
    auto* in = static_cast<double*>(std::aligned_alloc(64, n * trials * sizeof(double)));
    auto* out = static_cast<double*>(std::aligned_alloc(64, m * trials * sizeof(double)));
    std::vector<std::uint8_t> valid(trials);
    for (std::size_t i = 0; i < n * trials; ++i)
        in[i] = estimate_of(analysis->inputs, i / trials) + 1e-4 * std::sin(static_cast<double>(i));
    for (auto _ : state) {
        for (int block = 0; block < 977; ++block)
            analysis->model->evaluate_block({in, out, valid.data(), trials, trials});
        benchmark::ClobberMemory();
    }
    std::free(in);
    std::free(out);
}
BENCHMARK(equations)->Arg(13)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
