// Behaviour of the engine: reproducibility, replay, held components, failures, angles, special inputs.
#include "core/propagation/engine.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <numbers>
#include <thread>

#include "core/propagation/engine_parts.h"
#include "core/result/representation.h"
#include "test_models.h"

namespace covaria::test::engine_test {
namespace {

EvaluationOptions options_for(std::uint64_t trials) {
    EvaluationOptions options;
    options.trials = trials;
    options.seed = 7;
    return options;
}

RunControl with_threads(int threads) {
    RunControl control;
    control.threads = threads;
    return control;
}

/// Every number of a result, in one list.
std::vector<double> numbers_of(const UncertaintyResult& result) {
    std::vector<double> n{static_cast<double>(result.trials), static_cast<double>(result.failed_trials),
                          static_cast<double>(result.batches)};
    const auto add = [&n](std::initializer_list<double> values) { n.insert(n.end(), values); };
    for (const OutputResult& o : result.outputs) {
        add({o.estimate, o.standard_uncertainty, o.expanded_uncertainty, o.first_order.standard_uncertainty});
        if (!o.monte_carlo) continue;
        const MonteCarloOutput& m = *o.monte_carlo;
        add({m.mean, m.standard_uncertainty, m.symmetric.low, m.symmetric.high, m.shortest.low,
             m.shortest.high, m.skewness, m.kurtosis, m.minimum, m.maximum, m.histogram.low,
             m.histogram.high});
        n.insert(n.end(), m.quantiles.begin(), m.quantiles.end());
        n.insert(n.end(), m.histogram.counts.begin(), m.histogram.counts.end());
    }
    const Eigen::MatrixXd& covariance = result.covariance.whole();
    n.insert(n.end(), covariance.data(), covariance.data() + covariance.size());
    for (const CoverageRegion& r : result.regions)
        add({r.ellipsoid_monte_carlo.value_or(-1), r.rectangle_monte_carlo.value_or(-1)});
    for (const ConvergencePoint& p : result.convergence) {
        n.insert(n.end(), p.mean.begin(), p.mean.end());
        n.insert(n.end(), p.standard_uncertainty.begin(), p.standard_uncertainty.end());
    }
    for (const auto& rows : result.budget.rows)
        for (const BudgetRow& row : rows) add({row.share, row.one_at_a_time.value_or(-1)});
    return n;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

InputSet mixed_inputs() {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(Normal{2, 0.1}));
    add_quantity(inputs, "b", Distribution::of(Rectangular{-1, 1}));
    add_quantity(inputs, "c", Distribution::of(Normal{0, 0.2}));
    inputs.correlations = {{0, 2, 0.6}};
    return inputs;
}

/// Two measurands and an intermediate; no value where b > 0.95.
FunctionModel mixed_model() {
    auto outputs = outputs_named({"p", "q", "h"});
    outputs[2].role = OutputRole::intermediate;
    return FunctionModel(mixed_inputs(), outputs, [](std::span<const double> x, std::span<double> y) {
        y[0] = x[0] * x[0] + x[1];
        y[1] = x[0] * x[2] - x[1];
        y[2] = std::sqrt(0.95 - x[1]);
        return x[1] <= 0.95;
    });
}

TEST(Engine, TheSameBitsForAnyNumberOfThreads) {
    const FunctionModel model = mixed_model();
    for (Method method : {Method::monte_carlo, Method::adaptive}) {
        EvaluationOptions options = options_for(87'654);
        options.method = method;
        options.maximum_trials = 400'000;
        options.one_at_a_time_trials = 3'000;
        const auto one = evaluate(model, model.inputs(), options, with_threads(1));
        ASSERT_TRUE(one) << one.error().message.english();
        for (int threads : {2, 7}) {
            const auto many = evaluate(model, model.inputs(), options, with_threads(threads));
            ASSERT_TRUE(many);
            EXPECT_TRUE(same_bits(numbers_of(*one), numbers_of(*many))) << threads;
        }
        options.seed = 8;
        const auto other = evaluate(model, model.inputs(), options, with_threads(2));
        EXPECT_FALSE(same_bits(numbers_of(*one), numbers_of(*other)));
    }
}

/// Mean and shortest interval computed plainly from replayed trials.
TEST(Engine, ReplayEqualsTheRunAndItsStatistics) {
    const FunctionModel model = mixed_model();
    const std::uint64_t trials = 25'500;
    const auto result = evaluate(model, model.inputs(), options_for(trials));
    const auto replay = replay_trials(model, model.inputs(), 7, 0, trials);
    const auto part = replay_trials(model, model.inputs(), 7, 11'111, 222);
    ASSERT_TRUE(result && replay && part);
    for (Eigen::Index t = 0; t < 222; ++t)
        for (Eigen::Index j = 0; j < 3; ++j) {
            const double a = part->outputs(j, t), b = replay->outputs(j, 11'111 + t);
            EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b)));
        }
    std::vector<double> y;
    double sum = 0;
    for (Eigen::Index t = 0; t < replay->outputs.cols(); ++t)
        if (!std::isnan(replay->outputs(0, t))) {
            const double a = replay->inputs(0, t);
            EXPECT_EQ(replay->outputs(0, t), a * a + replay->inputs(1, t));
            y.push_back(replay->outputs(0, t));
            sum += y.back();
        }
    std::sort(y.begin(), y.end());
    const MonteCarloOutput& m = *result->outputs[0].monte_carlo;
    EXPECT_EQ(result->failed_trials, trials - y.size());
    EXPECT_NEAR(m.mean, sum / static_cast<double>(y.size()), 1e-12);
    EXPECT_EQ(m.minimum, y.front());
    EXPECT_EQ(m.maximum, y.back());
    // JCGM 101 7.7 on the sorted values, by hand.
    const auto n = y.size();
    const auto q = static_cast<std::size_t>(std::floor(0.95 * static_cast<double>(n) + 0.5));
    const std::size_t r = (n - q + 1) / 2;
    EXPECT_EQ(m.symmetric.low, y[r - 1]);
    EXPECT_EQ(m.symmetric.high, y[r + q - 1]);
    std::size_t best = 0;
    for (std::size_t i = 1; i + q < n; ++i)
        if (y[i + q] - y[i] < y[best + q] - y[best]) best = i;
    EXPECT_EQ(m.shortest.low, y[best]);
    EXPECT_EQ(m.shortest.high, y[best + q]);
}

TEST(Engine, HoldingAComponentLeavesTheOthersAlone) {
    const FunctionModel model = mixed_model();
    for (std::size_t held : {0u, 1u}) {
        InputSet inputs = model.inputs();
        inputs.components[held].held = true;
        const auto all = replay_trials(model, model.inputs(), 7, 0, 3000);
        const auto others = replay_trials(model, inputs, 7, 0, 3000);
        ASSERT_TRUE(all && others);
        for (Eigen::Index i = 0; i < 3; ++i) {
            if (i == static_cast<Eigen::Index>(held))
                EXPECT_EQ(others->inputs.row(i).minCoeff(), others->inputs.row(i).maxCoeff());
            else
                EXPECT_EQ(all->inputs.row(i), others->inputs.row(i));
        }
    }
}

TEST(Engine, CountsTrialsWithoutAValue) {
    const FunctionModel model = mixed_model();
    const auto result = evaluate(model, model.inputs(), options_for(100'000));
    ASSERT_TRUE(result);
    EXPECT_NEAR(static_cast<double>(result->failed_trials), 2500, 4 * std::sqrt(2500 * 0.975));
    ASSERT_FALSE(result->warnings.empty());
    EXPECT_NE(result->warnings[0].english().find("have no value"), std::string::npos);
    EXPECT_FALSE(represents_measurand(*result));
    EXPECT_NE(result->warnings[0].english().find(does_not_represent), std::string::npos);
    std::uint64_t counted =
        result->outputs[0].monte_carlo->histogram.below + result->outputs[0].monte_carlo->histogram.above;
    for (std::uint64_t c : result->outputs[0].monte_carlo->histogram.counts) counted += c;
    EXPECT_EQ(counted, result->trials - result->failed_trials);
}

TEST(Engine, NotANumberBehindAValidTrialIsAFailure) {
    const FunctionModel model(normal_inputs({{1, 1}}), outputs_named({"y"}),
                              [](std::span<const double> x, std::span<double> y) {
                                  y[0] = std::sqrt(x[0]);
                                  return true;
                              });
    const auto result = evaluate(model, model.inputs(), options_for(100'000));
    ASSERT_TRUE(result);
    EXPECT_NEAR(static_cast<double>(result->failed_trials), 15866, 4 * std::sqrt(15866 * 0.84));
    EXPECT_TRUE(std::isfinite(result->outputs[0].monte_carlo->standard_uncertainty));
}

TEST(Engine, AllTrialsFailing) {
    const FunctionModel model(
        normal_inputs({{0, 1}}), outputs_named({"y"}),
        [](std::span<const double> x, std::span<double> y) {
            y[0] = 1;
            return x[0] == 0.0;  // the estimate only
        },
        [](std::span<const double>, Eigen::MatrixXd& j) {
            j.setZero();
            return true;
        });
    const auto result = evaluate(model, model.inputs(), options_for(20'000));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::numeric);
}

TEST(Engine, NoValueAtTheEstimates) {
    const FunctionModel model(normal_inputs({{0, 1}}), outputs_named({"y"}),
                              [](std::span<const double>, std::span<double>) { return false; });
    const auto result = evaluate(model, model.inputs(), options_for(1000));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::numeric);
}

TEST(Engine, AnglesAreUnwrappedToTheEstimate) {
    const FunctionModel model = polar_model(normal_inputs({{-1, 0.01}, {0, 0.01}}));
    const auto result = evaluate(model, model.inputs(), options_for(100'000));
    ASSERT_TRUE(result);
    const OutputResult& angle = result->outputs[1];
    EXPECT_NEAR(angle.estimate, std::numbers::pi, 4 * 0.01 / std::sqrt(1e5));
    EXPECT_NEAR(angle.standard_uncertainty, 0.01, 4 * 0.01 / std::sqrt(2e5));
    EXPECT_TRUE(result->warnings.empty());
    const auto wide = evaluate(model, normal_inputs({{-0.01, 1}, {0, 1}}), options_for(50'000));
    ASSERT_TRUE(wide);
    bool said = false;
    for (const Message& w : wide->warnings)
        said = said || w.english().find("hardly determined") != std::string::npos;
    EXPECT_TRUE(said);
}

TEST(Engine, ZeroUncertaintyGivesZero) {
    const FunctionModel model = polar_model(normal_inputs({{3.3, 0}, {4.7, 0}}));
    EvaluationOptions options = options_for(30'000);
    for (Method method : {Method::monte_carlo, Method::adaptive}) {
        options.method = method;
        const auto result = evaluate(model, model.inputs(), options);
        ASSERT_TRUE(result) << result.error().message.english();
        EXPECT_TRUE(result->stabilised);
        for (double number : numbers_of(*result)) EXPECT_TRUE(std::isfinite(number));
        for (const OutputResult& output : result->outputs) {
            EXPECT_EQ(output.standard_uncertainty, 0.0);
            EXPECT_EQ(output.first_order.standard_uncertainty, 0.0);
            EXPECT_EQ(output.monte_carlo->symmetric.low, output.monte_carlo->symmetric.high);
            EXPECT_EQ(output.monte_carlo->shortest.low, output.estimate);
            EXPECT_EQ(output.monte_carlo->normality.words, "no spread");
            EXPECT_TRUE(output.first_order.validation->validated);
        }
        EXPECT_TRUE(result->regions[0].singular);
    }
}

TEST(Engine, CorrelatedInputsOfASum) {
    InputSet inputs = normal_inputs({{0, 3}, {0, 4}});
    inputs.correlations = {{0, 1, -0.5}};
    const auto result = evaluate(sum_model(inputs), inputs, options_for(200'000));
    ASSERT_TRUE(result);
    const double u = std::sqrt(9 + 16 - 12.0);
    EXPECT_NEAR(result->outputs[0].first_order.standard_uncertainty, u, 1e-12);
    EXPECT_NEAR(result->outputs[0].standard_uncertainty, u, 4 * u / std::sqrt(4e5));
    const auto& rows = result->budget.rows[0];
    EXPECT_EQ(rows[0].component, 1u);
    EXPECT_NEAR(rows[0].share, (16 - 6) / 13.0, 1e-12);
    EXPECT_NEAR(rows[1].share, (9 - 6) / 13.0, 1e-12);
}

TEST(Engine, ArithmeticCombinationAddsLinearly) {
    InputSet inputs = normal_inputs({{0, 1}, {0, 1}});
    inputs.quantities[0].shares = {{0, 1.0}, {1, 2.0}};
    inputs.quantities[1].shares = {};
    inputs.quantities[0].combination = Combination::arithmetic;
    const auto result = evaluate(sum_model(inputs), inputs, options_for(200'000));
    ASSERT_TRUE(result) << result.error().message.english();
    EXPECT_NEAR(result->outputs[0].first_order.standard_uncertainty, 3.0, 1e-12);
    EXPECT_NEAR(result->outputs[0].standard_uncertainty, 3.0, 4 * 3.0 / std::sqrt(4e5));
}

TEST(Engine, SharedComponentsCorrelateTheirQuantities) {
    InputSet inputs = normal_inputs({{0, 2}, {5, 0}});
    inputs.quantities[1].shares = {{0, -1.0}};
    const auto result = evaluate(sum_model(inputs), inputs, options_for(20'000));
    ASSERT_TRUE(result);
    EXPECT_EQ(result->outputs[0].first_order.standard_uncertainty, 0.0);
    EXPECT_EQ(result->outputs[0].standard_uncertainty, 0.0);
}

TEST(Engine, OneAtATimeHoldsEverythingElse) {
    InputSet inputs = normal_inputs({{0, 3}, {0, 4}});
    inputs.correlations = {{0, 1, 0.5}};
    EvaluationOptions options = options_for(1000);
    options.one_at_a_time_trials = 100'000;
    const auto result = evaluate(sum_model(inputs), inputs, options);
    ASSERT_TRUE(result);
    for (const BudgetRow& row : result->budget.rows[0]) {
        const double u = row.component == 0 ? 3.0 : 4.0;
        EXPECT_NEAR(row.one_at_a_time.value(), u, 4 * u / std::sqrt(2e5));
    }
}

TEST(Engine, CellsAgreeWithExactIntervals) {
    InputSet inputs;
    add_quantity(inputs, "x", Distribution::of(Exponential{1.0}));
    add_quantity(inputs, "z", Distribution::of(StudentT{0, 1, 1}));  // Cauchy: no moments
    const FunctionModel model(inputs, outputs_named({"x", "z"}),
                              [](std::span<const double> x, std::span<double> y) {
                                  y[0] = x[0];
                                  y[1] = x[1];
                                  return true;
                              });
    const auto exact = evaluate(model, inputs, options_for(300'000));
    detail::EngineSettings settings;
    settings.tail_bytes = 1000;
    const auto cells = detail::evaluate_with(model, inputs, options_for(300'000), {}, settings);
    ASSERT_TRUE(exact && cells);
    EXPECT_TRUE(exact->intervals_exact);
    EXPECT_FALSE(cells->intervals_exact);
    const auto near = [](double a, double b, double scale) { EXPECT_NEAR(a, b, 1e-3 * scale); };
    for (std::size_t j = 0; j < 2; ++j) {
        const MonteCarloOutput& a = *exact->outputs[j].monte_carlo;
        const MonteCarloOutput& b = *cells->outputs[j].monte_carlo;
        const double scale = a.symmetric.high - a.symmetric.low;
        near(a.symmetric.low, b.symmetric.low, scale);
        near(a.symmetric.high, b.symmetric.high, scale);
        near(a.shortest.high - a.shortest.low, b.shortest.high - b.shortest.low, scale);
        EXPECT_EQ(a.minimum, b.minimum);
        EXPECT_EQ(a.maximum, b.maximum);
        EXPECT_EQ(a.mean, b.mean);
    }
}

TEST(Engine, TailsThatWereTooShortAreCollectedAgain) {
    const FunctionModel model = mixed_model();
    detail::EngineSettings unlucky;
    unlucky.tail_margin = -15;
    const auto expected = evaluate(model, model.inputs(), options_for(120'000));
    const auto result = detail::evaluate_with(model, model.inputs(), options_for(120'000), {}, unlucky);
    ASSERT_TRUE(expected && result);
    for (std::size_t j = 0; j < 3; ++j) {
        const MonteCarloOutput& a = *expected->outputs[j].monte_carlo;
        const MonteCarloOutput& b = *result->outputs[j].monte_carlo;
        EXPECT_EQ(a.symmetric.low, b.symmetric.low);
        EXPECT_EQ(a.symmetric.high, b.symmetric.high);
        EXPECT_EQ(a.shortest.low, b.shortest.low);
        EXPECT_EQ(a.shortest.high, b.shortest.high);
    }
}

TEST(Engine, DiscreteOutputsCostNoMemoryAndHaveExactIntervals) {
    InputSet inputs;
    add_quantity(inputs, "d", Distribution::of(Discrete{{0, 1, 2}, {0.5, 0.4, 0.1}}));
    const auto result = evaluate(sum_model(inputs), inputs, options_for(100'000));
    ASSERT_TRUE(result) << result.error().message.english();
    const MonteCarloOutput& y = *result->outputs[0].monte_carlo;
    EXPECT_EQ(y.symmetric.low, 0.0);
    EXPECT_EQ(y.symmetric.high, 2.0);
    EXPECT_NEAR(y.quantiles[50], 0.0, 0.01);   // 25 %
    EXPECT_NEAR(y.quantiles[150], 1.0, 0.01);  // 76 %
    EXPECT_NEAR(y.quantiles[190], 2.0, 0.01);  // 96 %
}

TEST(Engine, QuantilesAndHistogramOfANormal) {
    const auto inputs = normal_inputs({{10, 2}});
    const auto result = evaluate(sum_model(inputs), inputs, options_for(1'000'000));
    ASSERT_TRUE(result);
    const MonteCarloOutput& y = *result->outputs[0].monte_carlo;
    ASSERT_EQ(y.quantiles.size(), 199u);
    const Distribution normal = Distribution::of(Normal{10, 2});
    for (std::size_t i = 0; i < 199; ++i) {
        const double p = (static_cast<double>(i) + 0.5) / 199, x = normal.quantile(p);
        const double se = std::sqrt(p * (1 - p) / 1e6) / normal.density(x);
        EXPECT_NEAR(y.quantiles[i], x, 4 * se + 1e-3 * 2);
    }
    EXPECT_EQ(y.histogram.counts.size(), 100u);
    EXPECT_NEAR(y.histogram.low, 0, 0.5);
    EXPECT_NEAR(y.histogram.high, 20, 0.5);
    EXPECT_TRUE(y.normality.acceptable);
    EXPECT_EQ(y.normality.words, "normal within 1 %");
    ASSERT_GE(result->convergence.size(), 7u);
    EXPECT_EQ(result->convergence.front().trials, 10'000u);
    EXPECT_EQ(result->convergence[1].trials, 20'000u);
    EXPECT_EQ(result->convergence.back().trials, 1'000'000u);
    EXPECT_EQ(result->convergence.back().mean[0], y.mean);
}

TEST(Engine, AdaptiveSaysWhenItHasNotStabilised) {
    const auto inputs = normal_inputs({{0, 1}});
    EvaluationOptions options = options_for(0);
    options.method = Method::adaptive;
    options.significant_digits = 3;
    options.maximum_trials = 120'000;
    const auto result = evaluate(sum_model(inputs), inputs, options);
    ASSERT_TRUE(result);
    EXPECT_FALSE(result->stabilised);
    EXPECT_EQ(result->trials, 120'000u);
    EXPECT_EQ(result->batches, 12u);
    EXPECT_NE(result->warnings.back().english().find("stopped at 120000 trials"), std::string::npos);
}

TEST(Engine, AdaptiveTakesAtLeastTheMinimumOfBatches) {
    const auto inputs = normal_inputs({{0, 1}});
    EvaluationOptions options = options_for(0);
    options.method = Method::adaptive;
    options.tolerance = Quantity{1.0, Unit()};
    options.minimum_batches = 4;
    const auto result = evaluate(sum_model(inputs), inputs, options);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->stabilised);
    EXPECT_EQ(result->batches, 4u);
    EXPECT_EQ(result->trials, 40'000u);
}

/// A model that is slow on purpose: a run of hours.
FunctionModel slow_model() {
    return FunctionModel(normal_inputs({{0, 1}}), outputs_named({"y"}),
                         [](std::span<const double> x, std::span<double> y) {
                             y[0] = x[0];
                             std::this_thread::sleep_for(std::chrono::microseconds(1));
                             return true;
                         });
}

TEST(Engine, StopsOnRequest) {
    const FunctionModel model = slow_model();
    for (int threads : {1, 3}) {
        std::stop_source stop;
        RunControl control = with_threads(threads);
        control.stop = stop.get_token();
        std::jthread later([&stop] {
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            stop.request_stop();
        });
        const auto result = evaluate(model, model.inputs(), options_for(2'000'000'000), control);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    }
}

TEST(Engine, ProgressComesOnTheCallingThread) {
    const FunctionModel model = slow_model();
    RunControl control = with_threads(2);
    const auto caller = std::this_thread::get_id();
    std::vector<std::uint64_t> seen;
    bool elsewhere = false;
    control.progress = [&](const Progress& progress) {
        elsewhere = elsewhere || std::this_thread::get_id() != caller;
        EXPECT_EQ(progress.trials_planned, 40'000u);
        seen.push_back(progress.trials_done);
    };
    ASSERT_TRUE(evaluate(model, model.inputs(), options_for(40'000), control));
    EXPECT_FALSE(seen.empty());
    EXPECT_FALSE(elsewhere);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

TEST(Engine, RefusesBadOptionsAndInputsByName) {
    const auto inputs = normal_inputs({{0, 1}});
    const FunctionModel model = sum_model(inputs);
    const auto path_of = [&](auto change) {
        EvaluationOptions options = options_for(1000);
        change(options);
        const auto result = evaluate(model, inputs, options);
        return result ? std::string("accepted") : result.error().path;
    };
    EXPECT_EQ(path_of([](EvaluationOptions&) {}), "accepted");
    EXPECT_EQ(path_of([](EvaluationOptions& o) { o.trials = 1; }), "/trials");
    EXPECT_EQ(path_of([](EvaluationOptions& o) { o.coverage_probability = 1; }), "/coverage_probability");
    EXPECT_EQ(path_of([](EvaluationOptions& o) { o.coverage_factor = -2; }), "/coverage_factor");
    EXPECT_EQ(path_of([](EvaluationOptions& o) { o.minimum_batches = 1; }), "/minimum_batches");
    EXPECT_EQ(path_of([](EvaluationOptions& o) {
                  o.method = Method::adaptive;
                  o.maximum_trials = 19'999;
              }),
              "/maximum_trials");
    InputSet broken = inputs;
    broken.quantities[0].offset = std::nan("");
    EXPECT_EQ(evaluate(model, broken, options_for(1000)).error().path, "/quantities/0/offset");
    broken = inputs;
    broken.components[0].degrees_of_freedom = 0;
    EXPECT_EQ(evaluate(model, broken, options_for(1000)).error().path, "/components/0/degrees_of_freedom");
    broken.quantities.clear();
    EXPECT_EQ(evaluate(model, broken, options_for(1000)).error().code, ErrorCode::bad_input);
}

TEST(Engine, RegionsOfPositionAndOrientation) {
    auto outputs = outputs_named({"x", "y", "z", "alpha", "beta", "gamma"});
    for (std::size_t j = 0; j < 6; ++j) {
        outputs[j].unit = Unit::of(j < 3 ? "mm" : "deg");
        outputs[j].group = "pose 1";
    }
    const FunctionModel model(normal_inputs({{0, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}}), outputs,
                              [](std::span<const double> x, std::span<double> y) {
                                  std::copy(x.begin(), x.end(), y.begin());
                                  return true;
                              });
    const auto result = evaluate(model, model.inputs(), options_for(100'000));
    ASSERT_TRUE(result);
    ASSERT_EQ(result->regions.size(), 3u);
    EXPECT_EQ(result->regions[1].outputs, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(result->regions[2].outputs, (std::vector<std::size_t>{3, 4, 5}));
    // chi-squared: k_p of 3 and 6 dimensions at 95 %
    EXPECT_NEAR(result->regions[1].ellipsoid_first_order, 2.7955, 1e-4);
    EXPECT_NEAR(*result->regions[1].ellipsoid_monte_carlo, 2.7955, 0.025);
    EXPECT_NEAR(*result->regions[0].ellipsoid_monte_carlo, 3.5485, 0.025);
    EXPECT_NEAR(result->regions[1].rectangle_first_order, 2.3940, 1e-4);
}

}  // namespace
}  // namespace covaria::test::engine_test
