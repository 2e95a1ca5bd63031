// Studies: 1,000 poses of the Stewart platform and 1,000 places of a target in a network, first order and
// with 10^5 trials at each.
#include <benchmark/benchmark.h>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "core/study/study.h"

namespace {

using namespace covaria;

Study map_of_a_volume(const std::string& table, std::size_t row) {
    Study study{.id = "map"};
    const char* const columns[] = {"x", "y", "z"};
    const double centres[] = {4000.0, 0.0, -200.0};
    for (std::size_t i = 0; i < 3; ++i)
        study.axes.push_back({.target = "/setup/" + table + "/rows/" + std::to_string(row) + "/" + columns[i],
                              .from = centres[i] - 500.0,
                              .to = centres[i] + 500.0,
                              .unit = Unit::of("mm"),
                              .values = 10});
    return study;
}

std::shared_ptr<const PreparedStudy> network_map(Method method) {
    Project project = load_project(data_directory() / "projects/lsm-network.covaria").project;
    AnalysisEntry analysis = *project.find_analysis("recommended");
    auto& targets = std::get<SetupTable>(analysis.setup.values.at("targets"));
    targets.rows = {targets.rows[1]};
    std::get<SetupTable>(analysis.setup.values.at("distances")).rows.clear();
    analysis.studies = {map_of_a_volume("targets", 0)};
    analysis.studies[0].method = method;
    project.analyses = {analysis};
    Problems problems;
    return prepare_study(MadeProject::make(project), analysis.id, "map", problems);
}

/// One pose of the platform, its position varied.
std::shared_ptr<const PreparedStudy> pose_map(Method method, std::uint64_t trials = 100'000,
                                              VarianceReduction reduction = VarianceReduction::none) {
    Project project = load_project(data_directory() / "projects/stewart-platform.covaria").project;
    AnalysisEntry& analysis = project.analyses.front();
    std::get<SetupTable>(analysis.setup.values.at("poses")).rows.resize(1);
    Problems problems;
    const auto choices = study_targets(project, analysis, nullptr);
    Study study{.id = "map", .method = method, .trials = trials};
    analysis.options.variance_reduction = reduction;
    for (const StudyTargetChoice& choice : choices) {
        if (study.axes.size() == 3) break;
        if (!choice.axis.asset.empty() || choice.target.kind != StudyTarget::Kind::cell) continue;
        study.axes.push_back(choice.axis);
        study.axes.back().values = 10;
        study.axes.back().from = choice.target.current - 10.0;
        study.axes.back().to = choice.target.current + 10.0;
    }
    analysis.studies = {study};
    return prepare_study(MadeProject::make(project), analysis.id, "map", problems);
}

void run(benchmark::State& state, const std::shared_ptr<const PreparedStudy>& study) {
    if (!study) return state.SkipWithError("the study cannot be prepared");
    RunControl control;
    control.threads = static_cast<int>(state.range(0));
    std::size_t failed = 0;
    for (auto _ : state) failed = run_study(*study, control)->failed();
    state.counters["without values"] = static_cast<double>(failed);
    state.SetItemsProcessed(state.iterations() * 1000);
}

void network_first_order(benchmark::State& state) {
    run(state, network_map(Method::first_order));
}
void pose_first_order(benchmark::State& state) {
    run(state, pose_map(Method::first_order));
}
void network_trials(benchmark::State& state) {
    run(state, network_map(Method::monte_carlo));
}

void pose_trials(benchmark::State& state) {
    run(state, pose_map(Method::monte_carlo));
}
/// Reaches the standard error of `pose_trials`, or less: see docs/performance.md.
void pose_control_variates(benchmark::State& state) {
    run(state, pose_map(Method::monte_carlo, 1'024, VarianceReduction::control_variate));
}

BENCHMARK(network_first_order)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(pose_first_order)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(pose_trials)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(pose_control_variates)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(network_trials)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
