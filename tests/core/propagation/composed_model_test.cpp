// Chains of models against the same written by hand as one model.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/model/composed_model.h"
#include "core/model/equation_model.h"
#include "core/model/linearised_model.h"
#include "core/propagation/engine.h"
#include "core/propagation/trial_block_runner.h"
#include "test_models.h"

namespace covaria::test::composed_model_test {
namespace {

/// A model of equations written as a generic function (x, y) -> whether there is a value.
template <class Equations>
class Written : public EquationModel<Written<Equations>> {
public:
    Written(InputSet inputs, std::vector<OutputQuantity> outputs, Equations equations)
        : inputs_(std::move(inputs)), outputs_(std::move(outputs)), equations_(std::move(equations)) {}
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double> x) const override {
        Layout layout;
        layout.points.push_back({.name = "p", .p_W = {x[0], x[1], 0.0}});
        return layout;
    }
    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        return equations_(x, y);
    }

private:
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    Equations equations_;
};

template <class Equations>
std::shared_ptr<const MeasurementModel> written(const InputSet& inputs,
                                                const std::vector<std::string>& symbols,
                                                Equations equations) {
    return std::make_shared<Written<Equations>>(inputs, outputs_named(symbols), equations);
}

ChainPart part(const std::string& id, std::shared_ptr<const MeasurementModel> model,
               std::vector<ModelLink> links = {}) {
    InputSet inputs = model->inputs();
    return {id, "", std::move(model), std::move(inputs), std::move(links)};
}

UncertaintyResult run(const MeasurementModel& model, std::uint64_t trials = 0) {
    EvaluationOptions options;
    options.method = trials == 0 ? Method::first_order : Method::monte_carlo;
    if (trials > 0) options.trials = trials;
    auto result = evaluate(model, model.inputs(), options, {});
    EXPECT_TRUE(result) << result.error().message.english();
    return result ? *std::move(result) : UncertaintyResult{};
}

void expect_same(const UncertaintyResult& chain, const UncertaintyResult& whole) {
    ASSERT_EQ(chain.outputs.size(), whole.outputs.size());
    for (std::size_t j = 0; j < whole.outputs.size(); ++j) {
        const FirstOrderOutput &a = chain.outputs[j].first_order, &b = whole.outputs[j].first_order;
        EXPECT_NEAR(a.estimate, b.estimate, 1e-12 * std::abs(b.estimate));
        EXPECT_NEAR(a.standard_uncertainty, b.standard_uncertainty, 1e-12 * b.standard_uncertainty);
        if (std::isfinite(b.effective_degrees_of_freedom)) {
            EXPECT_NEAR(a.effective_degrees_of_freedom, b.effective_degrees_of_freedom,
                        1e-9 * b.effective_degrees_of_freedom);
        }
        if (chain.trials == 0) continue;
        EXPECT_EQ(chain.outputs[j].monte_carlo->mean, whole.outputs[j].monte_carlo->mean);
        EXPECT_EQ(chain.outputs[j].monte_carlo->standard_uncertainty,
                  whole.outputs[j].monte_carlo->standard_uncertainty);
        EXPECT_EQ(chain.outputs[j].monte_carlo->shortest.low, whole.outputs[j].monte_carlo->shortest.low);
    }
    EXPECT_EQ(chain.failed_trials, whole.failed_trials);
}

const auto product_and_sum = [](const auto& x, auto& y) {
    y.set(0, x[0] * x[1]);
    y.set(1, x[0] + x[1]);
    return x[0] > 0.0;
};
const auto quotient = [](const auto& x, auto& y) {
    y.set(0, x[0] * x[0] / x[1] + x[2]);
    return x[1] > 0.0;
};

/// Two upstream outputs and one quantity of its own feed the quotient.
ComposedModel diamond(InputSet above, InputSet below) {
    const auto upstream = written(above, {"p", "s"}, product_and_sum);
    const auto downstream = written(below, {"q"}, quotient);
    std::vector<ChainPart> parts{part("above", upstream), part("below", downstream, {{0, 0, 0}, {1, 0, 1}})};
    return ComposedModel(std::move(parts));
}

/// The same as one equation; its own quantity comes first, then those of upstream.
auto diamond_by_hand(const InputSet& inputs) {
    return written(inputs, {"q"}, [](const auto& x, auto& y) {
        const auto p = x[1] * x[2], s = x[1] + x[2];
        y.set(0, p * p / s + x[0]);
        return x[1] > 0.0;
    });
}

}  // namespace

TEST(ComposedModel, IsTheModelWrittenByHandToTheBit) {
    InputSet above = normal_inputs({{2.0, 0.05}, {3.0, 0.1}}),
             below = normal_inputs({{1, 1}, {1, 1}, {0.5, 0.2}});
    above.components[0].degrees_of_freedom = 4.0;
    const ComposedModel chain = diamond(above, below);
    InputSet inputs = normal_inputs({{0.5, 0.2}, {2.0, 0.05}, {3.0, 0.1}});
    inputs.components[1].degrees_of_freedom = 4.0;
    const auto whole = diamond_by_hand(inputs);
    expect_same(run(chain), run(*whole));
    expect_same(run(chain, 50'000), run(*whole, 50'000));
}

TEST(ComposedModel, InputsAreThoseThatNothingIsTakenFor) {
    const ComposedModel chain =
        diamond(normal_inputs({{2, 0.1}, {3, 0.1}}), normal_inputs({{1, 1}, {1, 1}, {1, 1}}));
    ASSERT_EQ(chain.inputs().quantities.size(), 3u);
    EXPECT_EQ(chain.inputs().components.size(), 3u);  // without those of the linked quantities
    EXPECT_EQ(chain.inputs().quantities[0].analysis, "");
    EXPECT_EQ(chain.inputs().quantities[1].analysis, "above");
    EXPECT_EQ(chain.inputs().components[1].id, "above:" + normal_inputs({{0, 1}}).components[0].id);
    const UncertaintyResult result = run(chain);
    const auto groups = contributions_by_group(result.budget, 0, "analysis");
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_NEAR(groups[0].share + groups[1].share, 1.0, 1e-12);
    std::vector<double> x{1.0, 2.0, 3.0};
    EXPECT_EQ(chain.layout(x).points.at(0).p_W, Eigen::Vector3d(6.0, 5.0, 0.0));
}

TEST(ComposedModel, AComponentOnTwoWaysIsOne) {
    InputSet above = normal_inputs({{2.0, 0.05}, {3.0, 0.1}}),
             below = normal_inputs({{1, 1}, {1, 1}, {0.5, 0.2}});
    above.components[1].identity = below.components[2].identity = "tracker.scale";
    above.components[1].distribution = below.components[2].distribution = Distribution::normal(0.1);
    above.quantities[1].offset = 3.0;
    below.quantities[2].offset = 0.5;
    const ComposedModel chain = diamond(above, below);
    ASSERT_EQ(chain.inputs().components.size(), 2u);
    InputSet inputs = normal_inputs({{0.0, 0.1}, {2.0, 0.05}});
    inputs.quantities[0].offset = 0.5;
    inputs.quantities.push_back({.symbol = "b", .name = "b", .offset = 3.0, .shares = {{0, 1.0}}});
    const auto whole = diamond_by_hand(inputs);
    expect_same(run(chain), run(*whole));
    expect_same(run(chain, 20'000), run(*whole, 20'000));
    EXPECT_TRUE(chain.kept_apart().empty());

    above.components[1].held = true;  // no longer the same statement
    EXPECT_EQ(diamond(above, below).kept_apart().size(), 1u);
    EXPECT_EQ(diamond(above, below).inputs().components.size(), 3u);
}

TEST(ComposedModel, CorrelationsAndVarianceEstimatesAreThoseOfTheWhole) {
    InputSet above = normal_inputs({{2.0, 0.05}, {3.0, 0.1}}),
             below = normal_inputs({{1, 1}, {1, 1}, {0.5, 0.2}});
    above.correlations = {{0, 1, -0.4}};
    for (InputSet* inputs : {&above, &below}) {
        inputs->components.back().degrees_of_freedom = 5.0;
        inputs->rest_on_estimate("plate.s", inputs->components.size() - 1, true);
    }
    const ComposedModel chain = diamond(above, below);
    ASSERT_EQ(chain.inputs().variance_estimates.size(), 1u);
    InputSet inputs = normal_inputs({{0.5, 0.2}, {2.0, 0.05}, {3.0, 0.1}});
    inputs.correlations = {{1, 2, -0.4}};
    for (const std::size_t c : {0, 2}) {
        inputs.components[c].degrees_of_freedom = 5.0;
        inputs.rest_on_estimate("plate.s", c);
    }
    const auto whole = diamond_by_hand(inputs);
    expect_same(run(chain), run(*whole));
    expect_same(run(chain, 20'000), run(*whole, 20'000));
}

TEST(ComposedModel, ATrialWithoutValueUpstreamHasNoneDownstream) {
    const InputSet above = normal_inputs({{0.1, 0.1}, {3.0, 0.1}}),
                   below = normal_inputs({{1, 1}, {1, 1}, {0.5, 0.2}});
    const ComposedModel chain = diamond(above, below);
    const auto whole = diamond_by_hand(normal_inputs({{0.5, 0.2}, {0.1, 0.1}, {3.0, 0.1}}));
    const UncertaintyResult result = run(chain, 20'000);
    EXPECT_NEAR(static_cast<double>(result.failed_trials), 0.1587 * 20'000, 300);
    expect_same(result, run(*whole, 20'000));
    // A block without any.
    const ComposedModel none = diamond(normal_inputs({{-5.0, 0.1}, {3.0, 0.1}}), below);
    alignas(64) double inputs[3 * 8] = {}, outputs[8] = {};
    for (std::size_t t = 0; t < 8; ++t) inputs[8 + t] = -5.0;
    std::uint8_t valid[8];
    none.evaluate_block({inputs, outputs, valid, 8, 8});
    for (const std::uint8_t flag : valid) EXPECT_EQ(flag, 0);
}

TEST(ComposedModel, AnglesFromUpstreamStayOnTheBranchOfTheirEstimate) {
    InputSet inputs = normal_inputs({{-1.0, 0.02}, {1e-3, 0.02}});
    std::vector<OutputQuantity> periodic = outputs_named({"phi"});
    periodic[0].periodic = true;
    const auto upstream =
        std::make_shared<FunctionModel>(inputs, periodic, [](std::span<const double> x, std::span<double> y) {
            y[0] = std::atan2(x[1], x[0]);
            return true;
        });
    const auto twice = written(normal_inputs({{0, 1}}), {"z"}, [](const auto& x, auto& y) {
        y.set(0, x[0] * x[0]);
        return x[0] == x[0];
    });
    std::vector<ChainPart> parts{part("angle", upstream), part("square", twice, {{0, 0, 0}})};
    const ComposedModel chain(std::move(parts));
    const UncertaintyResult result = run(chain, 20'000);
    // Near pi^2, not two heaps at pi^2 and at what -pi would give through the jump.
    EXPECT_NEAR(result.outputs[0].monte_carlo->standard_uncertainty, 2 * std::numbers::pi * 0.02, 0.01);
}

TEST(ComposedModel, NestedChainsAreOneChain) {
    const InputSet one = normal_inputs({{1.0, 0.1}});
    const auto twice_plus = [](const auto& x, auto& y) {
        y.set(0, x[0] + x[0] + x[1]);
        return x[0] == x[0];
    };
    const InputSet two = normal_inputs({{1.0, 0.1}, {1.0, 0.2}});
    std::vector<ChainPart> parts{part("a", written(two, {"a"}, twice_plus)),
                                 part("b", written(two, {"b"}, twice_plus), {{0, 0, 0}}),
                                 part("c", written(two, {"c"}, twice_plus), {{0, 1, 0}, {1, 0, 0}})};
    const ComposedModel chain(std::move(parts));
    // c = 2 b + a, b = 2 a + e, a = 2 f + g: c = 5 a + 2 e
    const UncertaintyResult result = run(chain);
    const double u_a = std::hypot(0.2, 0.2);
    EXPECT_NEAR(result.outputs[0].first_order.standard_uncertainty, std::hypot(5 * u_a, 2 * 0.2), 1e-12);
    EXPECT_NEAR(result.outputs[0].first_order.estimate, 5 * 3.0 + 2, 1e-12);
    const auto linked = linked_quantities(chain.parts());
    const UncertaintyResult of_links = run(*linked);
    ASSERT_EQ(of_links.outputs.size(), 2u);
    EXPECT_NEAR(of_links.outputs[0].first_order.estimate, 7.0, 1e-12);
    EXPECT_NEAR(of_links.outputs[1].first_order.standard_uncertainty, u_a, 1e-12);
}

TEST(ComposedModel, LinearisedUpstreamIsTheSameToFirstOrder) {
    const InputSet above = normal_inputs({{2.0, 0.3}, {3.0, 0.3}}),
                   below = normal_inputs({{1, 1}, {1, 1}, {0.5, 0.2}});
    const auto upstream = written(above, {"p", "s"}, product_and_sum);
    const auto linear = linearised(upstream, above);
    ASSERT_TRUE(linear);
    EXPECT_TRUE(is_linearised(*linear));
    EXPECT_FALSE(is_linearised(*upstream));
    const auto downstream = written(below, {"q"}, quotient);
    std::vector<ChainPart> parts{part("above", linear), part("below", downstream, {{0, 0, 0}, {1, 0, 1}})};
    const ComposedModel chain(std::move(parts));
    expect_same(run(chain), run(diamond(above, below)));
    // p = 6 + 3 dx + 2 dy: without the product of both.
    const auto whole =
        written(normal_inputs({{0.5, 0.2}, {2.0, 0.3}, {3.0, 0.3}}), {"q"}, [](const auto& x, auto& y) {
            const auto p = x[1] * 3.0 + x[2] * 2.0 - 6.0, s = x[1] + x[2];
            y.set(0, p * p / s + x[0]);
            return x[1] == x[1];
        });
    const UncertaintyResult a = run(chain, 20'000), b = run(*whole, 20'000);
    EXPECT_NEAR(a.outputs[0].monte_carlo->standard_uncertainty,
                b.outputs[0].monte_carlo->standard_uncertainty, 1e-12);
    EXPECT_EQ(a.failed_trials, 0u);
    // No value at the estimates: no linear form.
    EXPECT_FALSE(linearised(written(normal_inputs({{-1, 0.1}, {1, 0.1}}), {"p", "s"}, product_and_sum),
                            normal_inputs({{-1, 0.1}, {1, 0.1}})));
}

}  // namespace covaria::test::composed_model_test
