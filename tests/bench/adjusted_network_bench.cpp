// The network adjustment: stations that nobody knows sight targets by direction, zenith angle and distance.
// Timed are the way from the table to the estimates with the u of every coordinate, a trial, one reading
// more, the reliability of all readings; with more targets, for the growth; the factor beside Eigen's; trials
// as the engine has them, in blocks and with their draws.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <Eigen/SparseCholesky>
#include <chrono>
#include <cmath>

#include "core/kinds/network/adjusted_closures.h"
#include "core/propagation/engine.h"
#include "core/propagation/trial_block_runner.h"
#include "core/readers/entry_texts.h"
#include "tests/core/made.h"

namespace {

using namespace covaria;
using namespace covaria::network;

/// A hall of 20 m x 16 m, four of its targets known; others with approximate coordinates or without. Each
/// target but those is sighted from `seen_by` stations.
StatedAdjustment stated_hall(std::size_t stations, std::size_t targets, bool approximate = true,
                             std::size_t seen_by = 1000) {
    StatedAdjustment stated;
    std::vector<Eigen::Vector3d> at;
    const auto add = [&](const std::string& name, const Eigen::Vector3d& p, CoordinateRole role) {
        stated.points.push_back({.name = name, .p = {}, .plane = role, .height = role, .u = {}});
        if (approximate || role == CoordinateRole::fixed) stated.points.back().p = {p.x(), p.y(), p.z()};
        at.push_back(p);
    };
    for (std::size_t s = 0; s < stations; ++s)
        add("S" + std::to_string(s),
            {2.0 * double(s % 10), s < stations / 2 ? -3.0 : 19.0, 1.5 + 0.1 * double(s % 3)},
            CoordinateRole::unknown);
    for (std::size_t t = 0; t < targets; ++t)
        add("P" + std::to_string(t), {0.5 * double(t % 40), 0.4 * double((t / 40) % 40), 0.3 * double(t % 7)},
            t < 4 ? CoordinateRole::fixed : CoordinateRole::unknown);
    double noise = 0.5;
    const auto next = [&] { return (noise = std::fmod(noise * 997.13 + 0.317, 1.0)) - 0.5; };
    for (std::size_t s = 0; s < stations; ++s)
        for (std::size_t t = 0; t < targets; ++t) {
            if (t >= 4 && (s + t) % stations >= seen_by) continue;
            const Eigen::Vector3d v = at[stations + t] - at[s];
            const std::string &from = stated.points[s].name, &to = stated.points[stations + t].name;
            const auto read = [&](ReadingKind kind, double value) {
                StatedAdjustment::Reading r{.kind = kind, .from = from, .to = to};
                const double u = is_of_angle(kind) ? 5e-6 : 2e-5;
                (is_of_angle(kind) ? r.angle : r.length) = value + u * next();
                (is_of_angle(kind) ? r.u_angle : r.u_length) = u;
                stated.readings.push_back(std::move(r));
            };
            read(ReadingKind::direction, std::atan2(v.y(), v.x()) - 0.1 * double(s));
            read(ReadingKind::zenith_angle, std::atan2(v.head<2>().norm(), v.z()));
            read(ReadingKind::slope_distance, v.norm());
        }
    return stated;
}

AdjustedNetwork adjusted_hall(std::size_t stations, std::size_t targets) {
    Problems problems;
    return std::move(*adjust_stated(stated_hall(stations, targets), problems));
}

double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Adjusts a table, and computes the u of every coordinate.
void adjust_and_all_u(benchmark::State& state) {
    StatedAdjustment stated =
        stated_hall(static_cast<std::size_t>(state.range(0)), static_cast<std::size_t>(state.range(1)),
                    state.range(2) == 1, static_cast<std::size_t>(state.range(3)));
    for (auto _ : state) {
        Problems problems;
        const std::optional<AdjustedNetwork> made = adjust_stated(std::move(stated), problems);
        if (!made) return state.SkipWithError("not adjusted");
        double sum = 0.0;
        for (std::size_t k = 0; k < made->place_of.size(); ++k)
            sum += std::sqrt(made->adjusted->cofactor(k, k));
        benchmark::DoNotOptimize(sum);
    }
    state.counters["peak_MB"] = peak_megabytes();
    state.SetLabel(state.range(2) == 1 ? "approximate coordinates" : "no coordinates");
}
BENCHMARK(adjust_and_all_u)
    ->Args({30, 250, 1, 30})
    ->Args({30, 1000, 1, 30})
    ->Args({30, 1000, 0, 30})
    ->Args({30, 4000, 1, 30})
    ->Args({100, 10000, 1, 10})
    ->Args({100, 10000, 1, 100})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// The parts of the same, one after the other.
void parts_of_it(benchmark::State& state) {
    const StatedAdjustment stated = stated_hall(30, 1000);
    Problems problems;
    const auto timed = [&](const char* name, const auto& part) {
        const auto begin = std::chrono::steady_clock::now();
        part();
        state.counters[name] =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    };
    for (auto _ : state) {
        std::optional<AdjustedNetwork> made;
        timed("set_up", [&] { made = adjusted_network(stated, problems); });
        timed("closures", [&] { benchmark::DoNotOptimize(closures(*made)); });
        timed("start", [&] { find_start(*made, problems); });
        adjustment::SparseRows design;
        timed("design", [&] { design = design_of(*made, made->state.data()); });
        timed("residuals", [&] { benchmark::DoNotOptimize(residuals_of(*made, made->state.data())); });
        std::optional<adjustment::Adjustment> first, second;
        timed("equations", [&] { first.emplace(design, made->whitening, made->datum); });
        timed("equations_again", [&] { second.emplace(design, made->whitening, made->datum, &*first); });
        timed("inverse", [&] { benchmark::DoNotOptimize(second->cofactor(0, 0)); });
        timed("whole_search", [&] { adjust(*made, problems); });
    }
}
BENCHMARK(parts_of_it)->Iterations(3)->Unit(benchmark::kMillisecond);

/// The lower triangle of the normal equations of a hall, with columns of the design of length one.
adjustment::SparseColumns normal_of(const AdjustedNetwork& made) {
    const adjustment::SparseRows scaled =
        made.adjusted->whitened() * made.adjusted->scale().cwiseInverse().asDiagonal();
    const adjustment::SparseColumns normal = adjustment::SparseColumns(scaled.transpose()) * scaled;
    return normal.triangularView<Eigen::Lower>();
}

void factor(benchmark::State& state) {
    const adjustment::SparseColumns normal = normal_of(adjusted_hall(30, 1000));
    adjustment::SparseFactor made;
    for (auto _ : state)
        benchmark::DoNotOptimize(made.factorise(normal, state.range(0) == 1 ? &made : nullptr));
    state.SetLabel(state.range(0) == 1 ? "order known" : "with its order");
}
BENCHMARK(factor)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void factor_of_eigen(benchmark::State& state) {
    const adjustment::SparseColumns normal = normal_of(adjusted_hall(30, 1000));
    Eigen::SimplicialLDLT<adjustment::SparseColumns, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt(normal);
    for (auto _ : state) {
        if (state.range(0) == 0) ldlt.analyzePattern(normal);
        ldlt.factorize(normal);
        benchmark::DoNotOptimize(ldlt.info());
    }
    state.SetLabel(state.range(0) == 1 ? "order known" : "with its order");
}
BENCHMARK(factor_of_eigen)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// The hall as a project, with the model that the window and the command line have.
Project project_of(const StatedAdjustment& stated) {
    AnalysisEntry analysis{.id = "hall", .model = "network-adjustment", .name = "hall"};
    TableRows points(table_of(analysis.model, "points")), readings(table_of(analysis.model, "readings"));
    for (const StatedAdjustment::Point& p : stated.points)
        points.add({{"name", p.name},
                    {"x", *p.p[0]},
                    {"y", *p.p[1]},
                    {"z", *p.p[2]},
                    {"plane", std::string(p.plane == CoordinateRole::fixed ? "fixed" : "unknown")},
                    {"height", std::string(p.plane == CoordinateRole::fixed ? "fixed" : "unknown")}});
    for (const StatedAdjustment::Reading& r : stated.readings) {
        const char* kind = r.kind == ReadingKind::direction      ? "direction"
                           : r.kind == ReadingKind::zenith_angle ? "zenith-angle"
                                                                 : "slope-distance";
        const auto cell = [](const std::optional<double>& v, double unit) {
            return v ? SetupCell(*v / unit) : SetupCell();
        };
        readings.add({{"kind", std::string(kind)},
                      {"from", r.from},
                      {"to", r.to},
                      {"length", cell(r.length, 1.0)},
                      {"angle", cell(r.angle, 1.0)},
                      {"u_length", cell(r.u_length, 1e-3)},
                      {"u_angle", cell(r.u_angle, 1.0)}});
    }
    analysis.setup.values["points"] = points.table();
    analysis.setup.values["readings"] = readings.table();
    Project project;
    project.analyses = {analysis};
    return project;
}

/// An edit to first-order results of the engine, with sensitivities of every output to every reading.
void first_order_of_the_engine(benchmark::State& state) {
    const Project project = project_of(
        stated_hall(static_cast<std::size_t>(state.range(0)), static_cast<std::size_t>(state.range(1))));
    for (auto _ : state) {
        Problems problems;
        const auto analysis = made_analysis(project, "hall", problems);
        if (!analysis) return state.SkipWithError("no analysis");
        benchmark::DoNotOptimize(evaluate_first_order(*analysis->propagated, analysis->options));
    }
    state.counters["peak_MB"] = peak_megabytes();
}
BENCHMARK(first_order_of_the_engine)
    ->Args({4, 50})
    ->Args({8, 100})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// One trial of the model: readings that deviate by one u each way.
void trial(benchmark::State& state) {
    Problems problems;
    const auto analysis = made_analysis(project_of(stated_hall(30, 1000)), "hall", problems);
    if (!analysis) return state.SkipWithError("no analysis");
    const InputSet& inputs = analysis->model->inputs();
    std::vector<double> x, y(analysis->model->outputs().size());
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i)
        x.push_back(estimate_of(inputs, i) + (i % 3 == 0   ? 1.0
                                              : i % 3 == 1 ? -1.0
                                                           : 0.3) *
                                                 standard_uncertainty_of(inputs, i));
    for (auto _ : state) {
        benchmark::DoNotOptimize(analysis->model->evaluate(x, y));
        benchmark::DoNotOptimize(y.data());
    }
}
BENCHMARK(trial)->Unit(benchmark::kMillisecond);

/// A block of trials of the engine, drawn and evaluated by one thread.
void block_of_trials(benchmark::State& state) {
    Problems problems;
    const auto analysis = made_analysis(project_of(stated_hall(30, 1000)), "hall", problems);
    if (!analysis) return state.SkipWithError("no analysis");
    const detail::DrawPlan plan(analysis->model->inputs(), {});
    detail::TrialSource source{analysis->model.get(), &plan, 1};
    source.estimate.setZero(static_cast<Eigen::Index>(analysis->model->outputs().size()));
    detail::TrialBlockRunner runner(source);
    detail::TrialRows inputs(plan.quantities());
    detail::DrawWorkspace workspace(plan.latent_rows());
    const auto ms_per_trial = [](const auto& part) {
        const auto begin = std::chrono::steady_clock::now();
        part();
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() /
               detail::block_trials;
    };
    runner.run(0, detail::block_trials);  // has its memory
    for (auto _ : state) {
        state.counters["ms_per_trial"] = ms_per_trial([&] { runner.run(0, detail::block_trials); });
        state.counters["ms_of_draws"] =
            ms_per_trial([&] { plan.draw(1, 0, detail::block_trials, inputs, workspace); });
    }
    state.counters["valid"] = static_cast<double>(runner.valid());
}
BENCHMARK(block_of_trials)->Iterations(1)->Unit(benchmark::kMillisecond);

/// One reading more: the changes of all unknowns and of the u of all of them, by a rank-one update.
void one_reading_more(benchmark::State& state) {
    const AdjustedNetwork made = adjusted_hall(30, 1000);
    std::vector<double> u2;
    for (std::size_t k = 0; k < made.place_of.size(); ++k) u2.push_back(made.adjusted->cofactor(k, k));
    const Eigen::VectorXd a = made.adjusted->whitened().row(4711).transpose();
    for (auto _ : state) {
        const Eigen::VectorXd gain = made.adjusted->step(a);
        const double by = 1.0 / (1.0 + a.dot(gain));
        double sum = 0.0;
        for (std::size_t k = 0; k < u2.size(); ++k)
            sum += std::sqrt(u2[k] -
                             by * gain[static_cast<Eigen::Index>(k)] * gain[static_cast<Eigen::Index>(k)]);
        benchmark::DoNotOptimize(sum);
    }
}
BENCHMARK(one_reading_more)->Unit(benchmark::kMillisecond);

void reliability(benchmark::State& state) {
    const AdjustedNetwork made = adjusted_hall(static_cast<std::size_t>(state.range(0)), 1000);
    const Eigen::VectorXd residuals = residuals_of(made, made.state.data());
    for (auto _ : state)
        benchmark::DoNotOptimize(
            adjustment::reliability_of(*made.adjusted, made.whitening, made.blocks, residuals));
}
BENCHMARK(reliability)->Arg(30)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
