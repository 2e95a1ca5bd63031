// The network adjustment: stations that nobody knows sight targets by direction, zenith angle and distance.
// Timed are the way from the table to the estimates with the u of every coordinate, a trial, the reliability
// of all readings; with more targets, for the growth.
#include <benchmark/benchmark.h>

#include <cmath>

#include "core/kinds/network/adjusted_setup.h"

namespace {

using namespace covaria;
using namespace covaria::network;

/// A hall of 20 m x 16 m, four of its targets known.
StatedAdjustment stated_hall(std::size_t stations, std::size_t targets) {
    StatedAdjustment stated;
    std::vector<Eigen::Vector3d> at;
    const auto add = [&](const std::string& name, const Eigen::Vector3d& p, CoordinateRole role) {
        stated.points.push_back(
            {.name = name, .p = {p.x(), p.y(), p.z()}, .plane = role, .height = role, .u = {}});
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

/// Adjusts a table, and computes the u of every coordinate.
void adjust_and_all_u(benchmark::State& state) {
    const StatedAdjustment stated =
        stated_hall(static_cast<std::size_t>(state.range(0)), static_cast<std::size_t>(state.range(1)));
    for (auto _ : state) {
        Problems problems;
        const std::optional<AdjustedNetwork> made = adjust_stated(stated, problems);
        if (!made) return state.SkipWithError("not adjusted");
        double sum = 0.0;
        for (std::size_t k = 0; k < made->place_of.size(); ++k)
            sum += std::sqrt(made->adjusted->cofactor(k, k));
        benchmark::DoNotOptimize(sum);
    }
}
BENCHMARK(adjust_and_all_u)
    ->Args({30, 250})
    ->Args({30, 1000})
    ->Args({30, 4000})
    ->Args({100, 10000})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// One Gauss-Newton step from new readings, with the factor at the estimates.
void trial(benchmark::State& state) {
    const AdjustedNetwork made = adjusted_hall(30, 1000);
    const adjustment::SparseRows gradient =
        adjustment::SparseRows((made.whitening.transpose() * made.adjusted->whitened()).transpose());
    for (auto _ : state) {
        const Eigen::VectorXd r = residuals_of(made, made.state.data());
        benchmark::DoNotOptimize(made.adjusted->step(gradient * r));
    }
}
BENCHMARK(trial)->Unit(benchmark::kMillisecond);

void reliability(benchmark::State& state) {
    const AdjustedNetwork made = adjusted_hall(30, 1000);
    const Eigen::VectorXd residuals = residuals_of(made, made.state.data());
    for (auto _ : state)
        benchmark::DoNotOptimize(
            adjustment::reliability_of(*made.adjusted, made.whitening, made.blocks, residuals));
}
BENCHMARK(reliability)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
