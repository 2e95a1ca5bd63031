// The hot loop does not use the heap: counted by replacing operator new and malloc's users in this
// executable.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/model/composed_model.h"
#include "core/propagation/unit_statistics.h"
#include "test_models.h"

namespace {
std::atomic<std::uint64_t> allocations{0};
}

// Eigen allocates its work space with malloc: count that too, through the C library's own entrance.
extern "C" void* __libc_malloc(std::size_t size);
#if !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
extern "C" void* malloc(std::size_t size) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    return __libc_malloc(size);
}
#endif

namespace covaria::test::allocation_test {
namespace {

TEST(HotLoop, DoesNotAllocate) {
    // Many outputs, correlated and independent inputs, an angle, trials without a value.
    InputSet inputs = normal_inputs(std::vector<std::pair<double, double>>(30, {1.0, 0.1}));
    inputs.correlations = {{0, 1, 0.5}, {1, 2, 0.2}};
    for (std::size_t c : {1, 4, 5}) {
        inputs.components[c].degrees_of_freedom = 5.0;
        inputs.rest_on_estimate("s", c);
    }
    inputs.components[6].degrees_of_freedom = 3.0;
    std::vector<std::string> symbols;
    for (int j = 0; j < 60; ++j) symbols.push_back("y" + std::to_string(j));
    auto outputs = outputs_named(symbols);
    outputs[3].periodic = true;
    const FunctionModel model(inputs, outputs, [](std::span<const double> x, std::span<double> y) {
        for (std::size_t j = 0; j < y.size(); ++j) y[j] = x[j % x.size()] * x[(j + 1) % x.size()];
        return x[0] < 1.2;
    });
    const detail::DrawPlan plan(inputs, inputs.correlations);
    const detail::TrialSource source{&model, &plan, 1, Eigen::VectorXd::Ones(60)};
    const RunControl control;
    const detail::EngineSettings settings;
    detail::RunMonitor monitor(control, 0);
    const auto pilot = detail::run_pilot({source, 0.95, settings, monitor}, 100'000);
    ASSERT_TRUE(pilot);
    detail::TrialBlockRunner runner(source);
    detail::TrialRows scratch(60);
    detail::UnitStatistics statistics(*pilot);
    const auto unit = [&] {
        statistics.clear();
        for (std::uint64_t block = 0; block < 10; ++block) {
            runner.run(block * detail::block_trials, detail::block_trials);
            statistics.add(*pilot, runner, scratch);
        }
    };
    unit();
    const std::uint64_t before = allocations;
    unit();
    EXPECT_EQ(allocations - before, 0u);
#if !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
    EXPECT_GT(before, 0u);  // the counter works
#endif
}

TEST(HotLoop, AChainOfModelsDoesNotAllocate) {
    const InputSet two = normal_inputs({{1.0, 0.5}, {2.0, 0.1}});
    const auto product = [](std::span<const double> x, std::span<double> y) {
        y[0] = x[0] * x[1];
        return x[0] > 0.0;
    };
    const auto model = std::make_shared<FunctionModel>(two, outputs_named({"y"}), product);
    std::vector<ChainPart> parts{{"a", "", model, two, {}}, {"b", "", model, two, {{1, 0, 0}}}};
    const ComposedModel chain(std::move(parts));
    const detail::DrawPlan plan(chain.inputs(), {});
    const detail::TrialSource source{&chain, &plan, 1, Eigen::VectorXd::Ones(1)};
    detail::TrialBlockRunner runner(source);
    runner.run(0, detail::block_trials);
    const std::uint64_t before = allocations;
    for (std::uint64_t block = 1; block < 10; ++block)
        runner.run(block * detail::block_trials, detail::block_trials);
    EXPECT_EQ(allocations - before, 0u);
    EXPECT_LT(runner.valid(), runner.trials());
}

}  // namespace
}  // namespace covaria::test::allocation_test
