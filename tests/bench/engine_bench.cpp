// The engine at the size of the Stewart platform of Porath et al.: 126 inputs, 78 outputs (13 poses).
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "core/propagation/engine.h"

namespace {

using namespace covaria;

constexpr std::size_t poses = 13;
constexpr std::size_t base_inputs = 9;
constexpr std::size_t inputs_per_pose = 9;

/// Arithmetic of about the cost of a pose: three outputs of length, three angles, from 18 coordinates each.
class SyntheticPoses : public MeasurementModel {
public:
    SyntheticPoses() {
        const std::size_t n = base_inputs + poses * inputs_per_pose;
        for (std::size_t i = 0; i < n; ++i) {
            UncertaintyComponent component;
            component.id = "e" + std::to_string(i);
            component.distribution = Distribution::normal(1e-4);
            InputQuantity quantity;
            quantity.symbol = "x" + std::to_string(i);
            quantity.offset = 0.1 + 0.01 * static_cast<double>(i % 18);
            quantity.shares = {{i, 1.0}};
            inputs_.components.push_back(component);
            inputs_.quantities.push_back(quantity);
        }
        for (std::size_t p = 0; p < poses; ++p)
            for (const char* symbol : {"x", "y", "z", "alpha", "beta", "gamma"}) {
                OutputQuantity output;
                output.symbol = symbol;
                output.group = "pose " + std::to_string(p + 1);
                output.periodic = symbol[0] > 'Z' && symbol[1] != 0;
                outputs_.push_back(output);
            }
    }
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        for (std::size_t p = 0; p < poses; ++p)
            pose(x.data(), x.data() + base_inputs + p * inputs_per_pose, y.data() + 6 * p, 1, 1);
        return true;
    }
    void evaluate_block(const TrialBlock& block) const override {
        for (std::size_t p = 0; p < poses; ++p)
            pose(block.inputs, block.inputs + (base_inputs + p * inputs_per_pose) * block.stride,
                 block.outputs + 6 * p * block.stride, block.stride, block.trials);
        for (std::size_t t = 0; t < block.trials; ++t) block.valid[t] = 1;
    }
    /// y_j depends on the nine base inputs and the pose's own linearly and by one square root.
    bool jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const override {
        jacobian.setZero(static_cast<Eigen::Index>(outputs_.size()), static_cast<Eigen::Index>(x.size()));
        for (std::size_t p = 0; p < poses; ++p)
            for (std::size_t j = 0; j < 6; ++j)
                for (std::size_t i = 0; i < base_inputs; ++i) {
                    const std::size_t own = base_inputs + p * inputs_per_pose + i;
                    const auto row = static_cast<Eigen::Index>(6 * p + j);
                    jacobian(row, static_cast<Eigen::Index>(i)) = weight(i, j);
                    jacobian(row, static_cast<Eigen::Index>(own)) = -weight(i, j);
                }
        return true;
    }
    Layout layout(std::span<const double>) const override { return {}; }

private:
    static double weight(std::size_t i, std::size_t j) {
        return 0.1 * static_cast<double>(1 + (i * 5 + j * 3) % 7);
    }
    static void pose(const double* base, const double* own, double* y, std::size_t stride,
                     std::size_t trials) {
        for (std::size_t j = 0; j < 6; ++j)
            for (std::size_t t = 0; t < trials; ++t) {
                double sum = 0;
                for (std::size_t i = 0; i < base_inputs; ++i)
                    sum += weight(i, j) * (base[i * stride + t] - own[i * stride + t]);
                y[j * stride + t] = sum + 0.1 * std::sqrt(1 + sum * sum);
            }
    }
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
};

void propagate(benchmark::State& state) {
    const SyntheticPoses model;
    EvaluationOptions options;
    options.trials = static_cast<std::uint64_t>(state.range(0));
    RunControl control;
    control.threads = static_cast<int>(state.range(1));
    for (auto _ : state) benchmark::DoNotOptimize(evaluate(model, model.inputs(), options, control));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(propagate)
    ->Args({1'000'000, 1})
    ->Args({1'000'000, 2})
    ->Args({10'000'000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void first_order(benchmark::State& state) {
    const SyntheticPoses model;
    for (auto _ : state) benchmark::DoNotOptimize(evaluate_first_order(model, model.inputs(), {}));
}
BENCHMARK(first_order)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
