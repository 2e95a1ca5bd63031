// Results of thousands of outputs keep the covariances of each group; every other figure is as with fewer.
#include <gtest/gtest.h>

#include <cmath>

#include "core/propagation/engine.h"
#include "core/propagation/evaluate_summary.h"
#include "core/result/joint_covariance.h"
#include "test_models.h"

namespace covaria::test::many_outputs_test {
namespace {

constexpr std::size_t inputs = 6;

/// Points whose coordinates depend on the same six quantities, each in its own way.
class Points : public MeasurementModel {
public:
    explicit Points(std::size_t points) {
        for (std::size_t i = 0; i < many_outputs_test::inputs; ++i)
            add_quantity(inputs_, "x_" + std::to_string(i),
                         Distribution::of(Normal{1.0, 0.1 * (1.0 + static_cast<double>(i))}));
        for (std::size_t k = 0; k < points; ++k)
            for (const char* symbol : {"x", "y", "z"}) {
                OutputQuantity output;
                output.symbol = symbol;
                output.group = "P" + std::to_string(k);
                outputs_.push_back(output);
            }
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        for (std::size_t j = 0; j < outputs_.size(); ++j) {
            y[j] = 0.0;
            for (std::size_t i = 0; i < many_outputs_test::inputs; ++i) y[j] += factor(j, i) * x[i];
        }
        return true;
    }
    void evaluate_block(const TrialBlock& block) const override {
        for (std::size_t t = 0; t < block.trials; ++t) block.valid[t] = 1;
        for (std::size_t j = 0; j < outputs_.size(); ++j)
            for (std::size_t t = 0; t < block.trials; ++t) {
                double y = 0.0;
                for (std::size_t i = 0; i < many_outputs_test::inputs; ++i)
                    y += factor(j, i) * block.inputs[i * block.stride + t];
                block.outputs[j * block.stride + t] = y;
            }
    }
    bool jacobian(std::span<const double>, Eigen::MatrixXd& jacobian) const override {
        jacobian = Eigen::MatrixXd::NullaryExpr(
            static_cast<Eigen::Index>(outputs_.size()), many_outputs_test::inputs,
            [](Eigen::Index j, Eigen::Index i) {
                return factor(static_cast<std::size_t>(j), static_cast<std::size_t>(i));
            });
        return true;
    }
    Layout layout(std::span<const double>) const override { return {}; }

private:
    static double factor(std::size_t j, std::size_t i) {
        return static_cast<double>((j * 7 + i * 5) % 11) - 5.0;
    }

    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
};

constexpr std::size_t one_block = OutputBlocks::most_in_one_block / 3, more = one_block + 1;

UncertaintyResult evaluated(std::size_t points, EvaluationOptions options) {
    const Points model(points);
    return *evaluate(model, model.inputs(), options);
}

class ManyOutputs : public testing::TestWithParam<VarianceReduction> {};

TEST_P(ManyOutputs, HaveTheCovariancesOfTheirGroups) {
    EvaluationOptions options;
    options.trials = 2'000;
    options.variance_reduction = GetParam();
    const UncertaintyResult few = evaluated(one_block, options), many = evaluated(more, options);
    ASSERT_TRUE(few.covariance.is_whole());
    ASSERT_FALSE(many.covariance.is_whole());
    ASSERT_EQ(many.covariance.blocks().list().size(), more);
    for (std::size_t j = 0; j < few.outputs.size(); ++j) {
        const OutputResult &a = few.outputs[j], &b = many.outputs[j];
        EXPECT_EQ(a.standard_uncertainty, b.standard_uncertainty) << j;
        EXPECT_EQ(a.monte_carlo->symmetric.low, b.monte_carlo->symmetric.low) << j;
        const std::size_t point = j / 3 * 3;
        const std::vector<std::size_t> group{point, point + 1, point + 2};
        EXPECT_TRUE(few.covariance.among(group).isApprox(many.covariance.among(group), 1e-12)) << j;
        EXPECT_TRUE(few.covariance_before_trials->among(group).isApprox(
            many.covariance_before_trials->among(group), 1e-12))
            << j;
    }
    EXPECT_TRUE(std::isnan(many.covariance(0, 3))) << "a pair of two points";
    ASSERT_EQ(few.regions.size() + 1, many.regions.size());
    for (std::size_t r = 0; r < few.regions.size(); ++r) {
        EXPECT_EQ(few.regions[r].singular, many.regions[r].singular);
        EXPECT_NEAR(*few.regions[r].rectangle_monte_carlo, *many.regions[r].rectangle_monte_carlo, 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutControls, ManyOutputs,
                         testing::Values(VarianceReduction::none, VarianceReduction::control_variate));

TEST(ManyOutputs, PairsOfTwoGroupsAreThoseOfTheLawOfPropagation) {
    EvaluationOptions options;
    options.method = Method::first_order;
    const UncertaintyResult few = evaluated(one_block, options), many = evaluated(more, options);
    const std::vector<PointCoordinates> points{{PointCoordinates::Kind::outputs, {0, 1, 2}},
                                               {PointCoordinates::Kind::outputs, {30, 31, 32}}};
    const auto a = JointCovariance(few).of(points), b = JointCovariance(many).of(points);
    ASSERT_TRUE(a && b);
    EXPECT_TRUE(a->isApprox(*b, 1e-12));
    const Points model(more);
    const auto summary =
        evaluate_summary(model, model.inputs(), {0, 31}, options, [](std::uint64_t) { return true; });
    ASSERT_TRUE(summary);
    EXPECT_NEAR(summary->covariance(0, 1), few.covariance(0, 31), 1e-12);
}

TEST(OutputBlocks, OfGroupsThatInterlockAreOne) {
    std::vector<OutputQuantity> outputs(OutputBlocks::most_in_one_block + 2);
    for (std::size_t j = 0; j < outputs.size(); ++j) outputs[j].group = "P" + std::to_string(j / 2);
    outputs[7].group = outputs[2].group;
    const OutputBlocks blocks = OutputBlocks::of(outputs);
    EXPECT_EQ(blocks.block_of(2), blocks.block_of(7));
    EXPECT_EQ(blocks.block_of(4), blocks.block_of(7));
    EXPECT_NE(blocks.block_of(1), blocks.block_of(2));
    EXPECT_EQ(blocks.outputs(), static_cast<Eigen::Index>(outputs.size()));
}

}  // namespace
}  // namespace covaria::test::many_outputs_test
