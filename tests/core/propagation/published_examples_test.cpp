// The engine against worked examples of JCGM 100, 101 and 102 (tests/data/gum_examples.json).
#include <gtest/gtest.h>

#include "core/propagation/engine.h"
#include "gum_examples.h"
#include "test_models.h"

namespace covaria::test::published_examples_test {
namespace {

using nlohmann::json;

EvaluationOptions monte_carlo(std::uint64_t trials, double probability = 0.95) {
    EvaluationOptions options;
    options.trials = trials;
    options.coverage_probability = probability;
    options.seed = 20260801;
    return options;
}

UncertaintyResult run(const MeasurementModel& model, const EvaluationOptions& options) {
    auto result = evaluate(model, model.inputs(), options);
    EXPECT_TRUE(result) << (result ? "" : result.error().message.english());
    return std::move(result.value());
}

void expect_printed(double value, const json& published, const char* what) {
    EXPECT_NEAR(value, published.at("value").get<double>(), published.at("half_ulp").get<double>() * 1.0001)
        << what;
}

/// 4 combined standard errors: reference of the example and one run of `trials` trials.
double allowed(const json& reference, double trials, double exponent = 0.5) {
    const double se = reference.at("se"),
                 sd = reference.at("sd_for_M_trials").get<double>() * std::pow(1e6 / trials, exponent);
    return 4 * std::sqrt(se * se + sd * sd);
}

void expect_monte_carlo(const MonteCarloOutput& output, const json& mc, double trials) {
    const auto check = [&](double value, const char* key, double exponent) {
        EXPECT_NEAR(value, mc.at(key).at("value").get<double>(), allowed(mc.at(key), trials, exponent))
            << key;
    };
    check(output.mean, "mean", 0.5);
    check(output.standard_uncertainty, "std", 0.5);
    check(output.symmetric.low, "sym_low", 0.5);
    check(output.symmetric.high, "sym_high", 0.5);
    check(output.shortest.low, "short_low", 1.0 / 3);
    check(output.shortest.high, "short_high", 1.0 / 3);
}

class Additive : public testing::TestWithParam<const char*> {};

TEST_P(Additive, Jcgm101_9_2) {
    const json& example = gum_example(GetParam());
    const FunctionModel model = sum_model(example_inputs(example));
    // Four times the usual trials: the verdict on 9.2.3 (0.0405 against 0.05) must stand clear of its
    // scatter.
    const UncertaintyResult result = run(model, monte_carlo(4'000'000));
    const OutputResult& y = result.outputs[0];
    const json& oracle = example.at("oracle");
    EXPECT_NEAR(y.first_order.standard_uncertainty, oracle["gum"]["u"].get<double>(), 1e-8);
    EXPECT_NEAR(y.first_order.expanded_uncertainty, oracle["validation"]["GUF_interval"][1].get<double>(),
                1e-7);
    expect_monte_carlo(*y.monte_carlo, oracle["mc"], 4e6);
    EXPECT_NEAR(y.monte_carlo->symmetric.high, oracle["exact"]["high95"].get<double>(),
                4 * oracle["mc"]["sym_high"]["sd_for_M_trials"].get<double>());
    EXPECT_EQ(y.first_order.validation->tolerance, oracle["validation"]["delta_ndig2"].get<double>());
    EXPECT_EQ(y.first_order.validation->validated, oracle["validation"]["GUF_validated_ndig2"].get<bool>());
    EXPECT_NEAR(y.first_order.validation->d_high, oracle["validation"]["d_high_exact"].get<double>(),
                4 * oracle["mc"]["sym_high"]["sd_for_M_trials"].get<double>());
}
INSTANTIATE_TEST_SUITE_P(Examples, Additive, testing::Values("S1-9.2.2", "S1-9.2.3", "S1-9.2.4"));

TEST(PublishedExamples, Clause8WithOneDigitAcceptsTheRectangularSum) {
    const FunctionModel model = sum_model(example_inputs(gum_example("S1-9.2.4")));
    EvaluationOptions options = monte_carlo(200'000);
    options.significant_digits = 1;
    options.coverage_factor = 2.0;  // displayed; the verdict uses the probability
    const auto result = run(model, options);
    EXPECT_TRUE(result.outputs[0].first_order.validation->validated);
    EXPECT_EQ(result.outputs[0].coverage_factor, 2.0);
    EXPECT_NEAR(result.outputs[0].first_order.validation->d_high, 2.8756, 0.1);
}

FunctionModel mass_model() {
    return FunctionModel(
        example_inputs(gum_example("S1-9.3")), outputs_named({"dm"}),
        [](std::span<const double> x, std::span<double> y) {
            y[0] = (x[0] + x[1]) * (1 + (x[2] - 1.2) * (1 / x[3] - 1 / x[4])) - 100000;
            return true;
        },
        [](std::span<const double> x, Eigen::MatrixXd& j) {
            const double m = x[0] + x[1], a = x[2] - 1.2, b = 1 / x[3] - 1 / x[4];
            j << 1 + a * b, 1 + a * b, m * b, -m * a / (x[3] * x[3]), m * a / (x[4] * x[4]);
            return true;
        });
}

TEST(PublishedExamples, MassCalibration) {
    const json& example = gum_example("S1-9.3");
    const FunctionModel model = mass_model();
    EvaluationOptions options = monte_carlo(1'000'000);
    options.second_order = true;
    options.significant_digits = 1;
    const auto result = run(model, options);
    const OutputResult& y = result.outputs[0];
    const json& oracle = example["oracle"];
    expect_printed(y.first_order.standard_uncertainty, example["published"]["u_GUF1"], "first order");
    expect_printed(*y.first_order.second_order_standard_uncertainty, example["published"]["u_GUF2"],
                   "second order");
    EXPECT_NEAR(*y.first_order.second_order_standard_uncertainty,
                oracle["gum"]["u_second_order"].get<double>(), 1e-6);
    EXPECT_NEAR(y.monte_carlo->standard_uncertainty, oracle["exact"]["u"].get<double>(),
                4 * oracle["mc"]["std"]["sd_for_M_trials"].get<double>());
    expect_monte_carlo(*y.monte_carlo, oracle["mc"], 1e6);
    EXPECT_FALSE(y.first_order.validation->validated);
    EXPECT_DOUBLE_EQ(y.first_order.validation->tolerance, 0.005);
}

TEST(PublishedExamples, MassCalibrationAdaptive) {
    const FunctionModel model = mass_model();
    EvaluationOptions options = monte_carlo(0);
    options.method = Method::adaptive;
    options.significant_digits = 1;
    options.minimum_batches = 2;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        options.seed = seed;
        const auto result = run(model, options);
        EXPECT_TRUE(result.stabilised);
        EXPECT_EQ(result.trials, result.batches * 10'000);
        EXPECT_LE(result.trials, 200'000u);
        EXPECT_NEAR(result.outputs[0].monte_carlo->standard_uncertainty, 0.0755, 0.005);
    }
}

TEST(PublishedExamples, ComparisonLoss) {
    for (const char* id : {"S1-9.4-x0.000-r0.0", "S1-9.4-x0.010-r0.0", "S1-9.4-x0.050-r0.0"}) {
        SCOPED_TRACE(id);
        const json& example = gum_example(id);
        const FunctionModel model(
            example_inputs(example), outputs_named({"dY"}),
            [](std::span<const double> x, std::span<double> y) {
                y[0] = x[0] * x[0] + x[1] * x[1];
                return true;
            },
            [](std::span<const double> x, Eigen::MatrixXd& j) {
                j << 2 * x[0], 2 * x[1];
                return true;
            });
        EvaluationOptions options = monte_carlo(1'000'000);
        options.second_order = true;
        InputSet inputs = model.inputs();
        inputs.correlations.clear();
        const auto result = evaluate(model, inputs, options);
        ASSERT_TRUE(result);
        const OutputResult& y = result->outputs[0];
        const json& exact = example["oracle"]["exact"];
        EXPECT_NEAR(y.first_order.standard_uncertainty, example["oracle"]["GUF1"]["u"].get<double>(), 1e-15);
        EXPECT_NEAR(*y.first_order.second_order_standard_uncertainty, exact["u"].get<double>(), 1e-12);
        EXPECT_NEAR(y.first_order.estimate + *y.first_order.second_order_estimate_shift,
                    exact["y"].get<double>(), 1e-12);
        const json& mc = example["oracle"]["mc"];
        const MonteCarloOutput& m = *y.monte_carlo;
        EXPECT_NEAR(m.mean, exact["y"].get<double>(), 4 * mc["mean"]["sd_for_M_trials"].get<double>());
        EXPECT_NEAR(m.standard_uncertainty, exact["u"].get<double>(),
                    4 * mc["std"]["sd_for_M_trials"].get<double>());
        EXPECT_NEAR(m.symmetric.low, exact["sym_low"].get<double>(),
                    4 * mc["sym_low"]["sd_for_M_trials"].get<double>());
        EXPECT_NEAR(m.symmetric.high, exact["sym_high"].get<double>(),
                    4 * mc["sym_high"]["sd_for_M_trials"].get<double>());
        EXPECT_NEAR(m.shortest.high, exact["short_high"].get<double>(),
                    4 * mc["short_high"]["sd_for_M_trials"].get<double>());
    }
}

FunctionModel gauge_block_model() {
    return FunctionModel(
        example_inputs(gum_example("S1-9.5")), outputs_named({"dL"}),
        [](std::span<const double> x, std::span<double> y) {
            y[0] = x[0] + x[1] + x[2] + x[3] - x[0] * (x[7] * (x[5] + x[6]) + x[4] * x[8]) - 5e7;
            return true;
        },
        [](std::span<const double> x, Eigen::MatrixXd& j) {
            j << 1 - (x[7] * (x[5] + x[6]) + x[4] * x[8]), 1, 1, 1, -x[0] * x[8], -x[0] * x[7], -x[0] * x[7],
                -x[0] * (x[5] + x[6]), -x[0] * x[4];
            return true;
        });
}

TEST(PublishedExamples, GaugeBlock) {
    const json& example = gum_example("S1-9.5");
    const FunctionModel model = gauge_block_model();
    for (const auto& [probability, key] : {std::pair(0.99, "mc99"), std::pair(0.95, "mc95")}) {
        EvaluationOptions options = monte_carlo(1'000'000, probability);
        options.second_order = true;
        const auto result = run(model, options);
        const OutputResult& y = result.outputs[0];
        const json& oracle = example["oracle"];
        EXPECT_NEAR(y.first_order.standard_uncertainty, oracle["gum"]["u"].get<double>(), 1e-6);
        EXPECT_NEAR(y.first_order.effective_degrees_of_freedom, oracle["gum"]["dof"].get<double>(), 1e-4);
        EXPECT_NEAR(*y.first_order.second_order_standard_uncertainty,
                    oracle["gum"]["u_second_order"].get<double>(), 1e-4);
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty, oracle["exact"]["u"].get<double>(),
                    4 * oracle[key]["std"]["sd_for_M_trials"].get<double>());
        expect_monte_carlo(*y.monte_carlo, oracle[key], 1e6);
    }
}

TEST(PublishedExamples, GaugeBlockAdaptiveReachesItsTolerance) {
    const FunctionModel model = gauge_block_model();
    EvaluationOptions options = monte_carlo(0, 0.99);
    options.method = Method::adaptive;
    const auto result = run(model, options);
    EXPECT_TRUE(result.stabilised);
    EXPECT_GE(result.batches, 10u);
    EXPECT_LT(result.trials, 3'000'000u);
    const MonteCarloOutput& y = *result.outputs[0].monte_carlo;
    EXPECT_NEAR(y.symmetric.low, 744.348436, 1.0);  // delta = 0.5 is two standard deviations
    EXPECT_NEAR(y.symmetric.high, 931.651564, 1.0);
}

TEST(PublishedExamples, EndGauge) {
    const json& example = gum_example("GUM-H1");
    const FunctionModel model(
        example_inputs(example), outputs_named({"l"}),
        [](std::span<const double> x, std::span<double> y) {
            y[0] = x[0] + x[1] - x[0] * (x[2] * x[3] + x[4] * x[5]);
            return true;
        },
        [](std::span<const double> x, Eigen::MatrixXd& j) {
            j << 1 - (x[2] * x[3] + x[4] * x[5]), 1, -x[0] * x[3], -x[0] * x[2], -x[0] * x[5], -x[0] * x[4];
            return true;
        });
    // Table H.1 rounds the u of the rectangular inputs: 0.58e-6, 1.2e-6, 0.029.
    InputSet inputs = model.inputs();
    for (std::size_t i = 0; i < inputs.components.size(); ++i) {
        const json& input = example["inputs"][i];
        inputs.components[i].distribution = Distribution::of(Normal{input["x"], input["u"]});
    }
    EvaluationOptions options;
    options.coverage_probability = 0.99;
    options.second_order = true;
    options.method = Method::first_order;
    const auto result = evaluate(model, inputs, options);
    ASSERT_TRUE(result);
    const FirstOrderOutput& l = result->outputs[0].first_order;
    const json& oracle = example["oracle"];
    EXPECT_NEAR(l.estimate, 50000838.0, 1e-7);
    EXPECT_NEAR(l.standard_uncertainty, oracle["gum"]["u"].get<double>(), 1e-7);
    EXPECT_NEAR(l.effective_degrees_of_freedom, oracle["gum"]["dof"].get<double>(), 1e-6);
    EXPECT_NEAR(l.coverage_factor, oracle["k99_nu_interpolated"].get<double>(), 2e-3);
    EXPECT_NEAR(*l.second_order_standard_uncertainty, oracle["gum"]["u_second_order"].get<double>(), 1e-6);
    EXPECT_FALSE(result->outputs[0].monte_carlo.has_value());
    EXPECT_FALSE(l.validation.has_value());
    EXPECT_EQ(result->trials, 0u);
    EXPECT_EQ(result->budget.rows[0][0].component, 0u);
    EXPECT_NEAR(result->budget.rows[0][0].contribution, 25.0, 1e-9);
}

FunctionModel impedance_model(bool with_z) {
    auto symbols = with_z ? std::vector<std::string>{"R", "X", "Z"} : std::vector<std::string>{"R", "X"};
    return FunctionModel(
        example_inputs(gum_example("GUM-H2")), outputs_named(symbols),
        [with_z](std::span<const double> x, std::span<double> y) {
            const double z = x[0] / x[1];
            y[0] = z * std::cos(x[2]);
            y[1] = z * std::sin(x[2]);
            if (with_z) y[2] = z;
            return true;
        },
        [with_z](std::span<const double> x, Eigen::MatrixXd& j) {
            const double z = x[0] / x[1], c = std::cos(x[2]), s = std::sin(x[2]);
            j.row(0) << c / x[1], -z * c / x[1], -z * s;
            j.row(1) << s / x[1], -z * s / x[1], z * c;
            if (with_z) j.row(2) << 1 / x[1], -z / x[1], 0;
            return true;
        });
}

TEST(PublishedExamples, ResistanceAndReactanceFirstOrder) {
    const FunctionModel model = impedance_model(true);
    EvaluationOptions options = monte_carlo(100'000);
    const auto result = run(model, options);
    const json& oracle = gum_example("GUM-H2")["oracle"];
    const auto r = correlation_of(first_order_covariance(result).whole());
    const char* symbols[] = {"R", "X", "Z"};
    for (std::size_t j = 0; j < 3; ++j) {
        const json& expected = oracle["approach1"][symbols[j]];
        EXPECT_NEAR(result.outputs[j].first_order.estimate, expected["y"].get<double>(), 1e-7);
        EXPECT_NEAR(result.outputs[j].first_order.standard_uncertainty, expected["u"].get<double>(), 1e-8);
    }
    EXPECT_NEAR(r(0, 1), oracle["approach1_corr"]["R,X"].get<double>(), 1e-7);
    EXPECT_NEAR(r(0, 2), oracle["approach1_corr"]["R,Z"].get<double>(), 1e-7);
    EXPECT_NEAR(r(1, 2), oracle["approach1_corr"]["X,Z"].get<double>(), 1e-7);
    ASSERT_EQ(result.regions.size(), 1u);
    EXPECT_TRUE(result.regions[0].singular);
    EXPECT_FALSE(result.regions[0].ellipsoid_monte_carlo.has_value());
    EXPECT_TRUE(result.regions[0].rectangle_monte_carlo.has_value());
}

TEST(PublishedExamples, CorrelatedInputsOfOneEnsembleKeepTheirDegreesOfFreedom) {
    const FunctionModel model = impedance_model(false);
    InputSet inputs = model.inputs();
    for (std::size_t c = 0; c < inputs.components.size(); ++c) {
        inputs.components[c].degrees_of_freedom = 4;
        inputs.rest_on_estimate("simultaneous observations", c);
    }
    const auto result = evaluate_first_order(model, inputs, monte_carlo(10));
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->outputs[0].first_order.effective_degrees_of_freedom, 4.0, 1e-9);
    EXPECT_TRUE(result->warnings.empty()) << "a quadratic form of one Wishart matrix: exact";
    double shares = 0;
    for (const BudgetRow& row : result->budget.rows[0]) shares += row.share;
    EXPECT_NEAR(shares, 1.0, 1e-12);
    // F_{2, 4}(0.95) = 2 (0.05^(-1/2) - 1), in closed form; t_4(0.9875) = 3.4954.
    ASSERT_EQ(result->regions.size(), 1u);
    EXPECT_NEAR(result->regions[0].ellipsoid_first_order, std::sqrt(4.0 * (1.0 / std::sqrt(0.05) - 1.0)),
                1e-9);
    EXPECT_NEAR(result->regions[0].rectangle_first_order, 3.4954, 1e-4);
}

/// Region factors of JCGM 102 examples: references from 10^7 trials; here k comes from `trials` of the run.
void expect_region(const UncertaintyResult& result, const json& reference) {
    const double m = static_cast<double>(result.trials);
    const auto check = [&](double value, const char* key, double trials) {
        EXPECT_NEAR(value, reference[key]["value"].get<double>(),
                    4 * reference[key]["se"].get<double>() * std::sqrt(1 + 1e7 / trials))
            << key;
    };
    for (std::size_t j = 0; j < 2; ++j) {
        // The run knows its own standard errors better than the reference's ten batches do.
        const MonteCarloOutput& output = *result.outputs[j].monte_carlo;
        const json& y = reference[j == 0 ? "y1" : "y2"];
        const json& u = reference[j == 0 ? "u1" : "u2"];
        EXPECT_NEAR(output.mean, y["value"].get<double>(),
                    4 * std::hypot(y["se"].get<double>(), output.standard_error_of_mean));
        EXPECT_NEAR(output.standard_uncertainty, u["value"].get<double>(),
                    4 * std::hypot(u["se"].get<double>(), output.standard_error_of_uncertainty));
    }
    check(correlation_of(result.covariance.whole())(0, 1), "r12", m);
    ASSERT_EQ(result.regions.size(), 1u);
    EXPECT_EQ(result.regions[0].trials, 100'000u);
    EXPECT_NEAR(result.regions[0].ellipsoid_first_order, 2.447746831, 1e-8);
    EXPECT_NEAR(result.regions[0].rectangle_first_order, 2.241402728, 1e-8);
    check(*result.regions[0].ellipsoid_monte_carlo, "k_p", 1e5);
    check(*result.regions[0].rectangle_monte_carlo, "k_q", 1e5);
}

TEST(PublishedExamples, BivariateAdditive) {
    const json& example = gum_example("S2-9.2-normal");
    const FunctionModel model(
        example_inputs(example), outputs_named({"Y1", "Y2"}),
        [](std::span<const double> x, std::span<double> y) {
            y[0] = x[0] + x[2];
            y[1] = x[1] + x[2];
            return true;
        },
        [](std::span<const double>, Eigen::MatrixXd& j) {
            j << 1, 0, 1, 0, 1, 1;
            return true;
        });
    expect_region(run(model, monte_carlo(1'000'000)), example["oracle"]["mc_region"]);
}

TEST(PublishedExamples, CartesianToPolar) {
    for (const char* id : {"S2-9.3-x0.001-r0.0", "S2-9.3-x0.010-r0.9"}) {
        SCOPED_TRACE(id);
        const json& example = gum_example(id);
        const FunctionModel model = polar_model(example_inputs(example));
        const auto result = run(model, monte_carlo(1'000'000));
        expect_region(result, example["oracle"]["mc_region"]);
        for (std::size_t j = 0; j < 2; ++j)
            EXPECT_NEAR(result.outputs[j].first_order.standard_uncertainty,
                        example["oracle"]["GUF"][j == 0 ? "u1" : "u2"].get<double>(), 1e-9);
    }
}

TEST(PublishedExamples, ResistanceAndReactanceMonteCarlo) {
    expect_region(run(impedance_model(false), monte_carlo(1'000'000)),
                  gum_example("S2-9.4")["oracle"]["mc_region_RX"]);
}

TEST(PublishedExamples, WelchSatterthwaite) {
    const json& oracle = gum_example("WS")["oracle"];
    // G.4.1: relative u of 0.25 %, 0.57 %, 0.82 % with 9, 4 and 14 degrees of freedom (n = 10, 5, 15).
    InputSet inputs;
    add_quantity(inputs, "X1", Distribution::of(Normal{1, 0.0025}), 9);
    add_quantity(inputs, "X2", Distribution::of(Normal{1, 0.0057}), 4);
    add_quantity(inputs, "X3", Distribution::of(Normal{1, 0.0082}), 14);
    auto result = evaluate_first_order(sum_model(inputs), inputs, monte_carlo(10));
    ASSERT_TRUE(result);
    const FirstOrderOutput& y = result->outputs[0].first_order;
    EXPECT_NEAR(y.standard_uncertainty * 100, oracle["G41"]["uc_percent"].get<double>(), 1e-8);
    EXPECT_NEAR(y.effective_degrees_of_freedom, oracle["G41"]["nu_eff"].get<double>(), 1e-7);
    EXPECT_NEAR(y.coverage_factor, 2.09303, 2e-5);

    InputSet equal;
    for (int i = 0; i < 4; ++i) add_quantity(equal, "x" + std::to_string(i), Distribution::normal(1), 10);
    result = evaluate_first_order(sum_model(equal), equal, monte_carlo(10));
    EXPECT_NEAR(result->outputs[0].first_order.effective_degrees_of_freedom,
                oracle["equal_4x10"].get<double>(), 1e-9);
}

}  // namespace
}  // namespace covaria::test::published_examples_test
