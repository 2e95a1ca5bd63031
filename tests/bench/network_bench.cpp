// The network of Galetto et al.: three targets, three cameras and a tracker (51 input, 12 output quantities),
// 10^6 trials with the linear GLS of the paper and with the joint non-linear estimator; first order, as after
// each move of a sensor; a network of 30 instruments and 1,000 targets (90,180 input, 3,000 output
// quantities).
#include <benchmark/benchmark.h>

#include "core/base/resource_path.h"
#include "core/propagation/engine.h"
#include "tests/bench/large_network.h"
#include "tests/core/made.h"

namespace {

using namespace covaria;

const char* const analyses[] = {"paper", "recommended"};

std::shared_ptr<const PreparedAnalysis> prepared(std::size_t estimator) {
    const Project project = load_project(data_directory() / "projects/lsm-network.covaria").project;
    Problems problems;
    return made_analysis(project, analyses[estimator], problems);
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

/// Edits a target and computes first-order results, as the window does.
class EditedNetwork {
public:
    explicit EditedNetwork(Project project, const char* analysis)
        : project_(std::move(project)), analysis_(analysis), made_(MadeProject::make(project_)) {}

    void edit_and_evaluate() {
        auto& targets = std::get<SetupTable>(project_.analyses.back().setup.values.at("targets"));
        std::get<double>(targets.rows[0][1]) += 0.1;
        made_ = MadeProject::make(project_, made_);
        const auto analysis = made_->analysis(analysis_);
        benchmark::DoNotOptimize(evaluate_first_order(*analysis->propagated, analysis->options));
    }

private:
    Project project_;
    const char* analysis_;
    MadeProject::Pointer made_;
};

void first_order_after_an_edit(benchmark::State& state) {
    EditedNetwork network(load_project(data_directory() / "projects/lsm-network.covaria").project,
                          "recommended");
    for (auto _ : state) network.edit_and_evaluate();
}
BENCHMARK(first_order_after_an_edit)->Unit(benchmark::kMillisecond);

void first_order_of_a_large_network(benchmark::State& state) {
    EditedNetwork network(
        bench::large_network(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))),
        "recommended");
    for (auto _ : state) network.edit_and_evaluate();
}
BENCHMARK(first_order_of_a_large_network)
    ->Args({4, 100})
    ->Args({30, 1000})
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

/// Forty points of poses that a network of three trackers measures: each of their coordinates has a share in
/// each of 360 readings.
void poses_by_a_network(benchmark::State& state) {
    Project project = bench::large_network(3, 1);
    AssetEntry network{.id = "network", .kind = "sensor-network", .name = "network"};
    network.setup.values["sensors"] =
        SetupTable{{Unit{}}, {{std::string("T0")}, {std::string("T1")}, {std::string("T2")}}};
    project.assets.push_back(network);
    project.analyses = {*load_project(data_directory() / "projects/stewart-platform.covaria")
                             .project.find_analysis("printed")};
    AnalysisEntry& poses = project.analyses.front();
    poses.studies.clear();
    poses.designs.clear();
    for (const char* side : {"base", "moving"}) {
        poses.setup.values[std::string(side) + "_uncertainty"] = std::string("asset");
        poses.setup.values[std::string(side) + "_asset"] = network.id;
    }
    poses.options.method = Method::first_order;
    for (auto _ : state) {
        Problems problems;
        const auto analysis = made_analysis(project, poses.id, problems);
        if (!analysis) return state.SkipWithError("no analysis");
        const auto result = evaluate_first_order(*analysis->propagated, analysis->options);
        double sum = 0.0;
        for (std::size_t i = 0; i < analysis->inputs.quantities.size(); ++i)
            sum += standard_uncertainty_of(analysis->inputs, i);
        benchmark::DoNotOptimize(sum);
        benchmark::DoNotOptimize(result);
    }
}
BENCHMARK(poses_by_a_network)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
