// Cost of the inverse normal distribution function and of the distribution function, per block of 1,024
// values.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "core/math/normal_quantile.h"

namespace {

constexpr std::size_t block = 1024;

std::vector<double> uniforms() {
    std::mt19937_64 generator(1);
    std::vector<double> p(block);
    for (double& x : p) x = (static_cast<double>(generator() >> 12) + 0.5) * 0x1p-52;
    return p;
}

void report(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(block));
}

void normal_quantiles(benchmark::State& state) {
    const std::vector<double> p = uniforms();
    std::vector<double> z(block);
    for (auto _ : state) {
        covaria::normal_quantiles(p, z);
        benchmark::DoNotOptimize(z.data());
        benchmark::ClobberMemory();
    }
    report(state);
}
BENCHMARK(normal_quantiles);

void normal_distribution_functions(benchmark::State& state) {
    std::vector<double> z = uniforms();
    covaria::normal_quantiles(z, z);
    std::vector<double> p(block);
    for (auto _ : state) {
        covaria::normal_distribution_functions(z, p);
        benchmark::DoNotOptimize(p.data());
        benchmark::ClobberMemory();
    }
    report(state);
}
BENCHMARK(normal_distribution_functions);

}  // namespace

BENCHMARK_MAIN();
