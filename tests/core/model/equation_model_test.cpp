// One set of equations in three forms: one trial, a block of trials, the Jacobian; and the defaults for
// models that have only the first.
#include "core/model/equation_model.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace covaria::equation_model_test {
namespace {

constexpr std::size_t inputs_count = 11;  // more than one pass of dual numbers, and not a multiple of 8

InputSet some_inputs() {
    InputSet inputs;
    for (std::size_t i = 0; i < inputs_count; ++i)
        inputs.add(
            {.symbol = "x_" + std::to_string(i), .name = "x"},
            {{.id = "x_" + std::to_string(i), .name = "x", .distribution = Distribution::normal(0.1)}});
    return inputs;
}

std::vector<OutputQuantity> some_outputs() {
    return {{.symbol = "s", .name = "sum of squares"},
            {.symbol = "r", .name = "root"},
            {.symbol = "a", .name = "angle", .periodic = true}};
}

// The root has no value for x_1 < 0.
struct Equations {
    template <class Real, class In, class Out>
    static auto apply(const In& x, Out& y) {
        using namespace real_functions;
        Real sum(0.0);
        for (std::size_t i = 0; i < inputs_count; ++i) sum += Real(double(i + 1)) * x[i] * x[i];
        const auto valid = x[1] >= Real(0.0);
        y.set(0, sum);
        y.set(1, sqrt(select(valid, x[1], Real(1.0))) * x[10]);
        y.set(2, atan2(x[0], x[9]));
        return valid;
    }
};

class ThreeForms : public EquationModel<ThreeForms> {
public:
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return {}; }
    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        return Equations::apply<Real>(x, y);
    }

private:
    InputSet inputs_ = some_inputs();
    std::vector<OutputQuantity> outputs_ = some_outputs();
};

class OneForm : public MeasurementModel {
public:
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return {}; }
    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        Outputs<double> out(y.data());
        return Equations::apply<double>(Inputs<double>(x.data()), out);
    }

private:
    InputSet inputs_ = some_inputs();
    std::vector<OutputQuantity> outputs_ = some_outputs();
};

// 13 trials (not a multiple of the batch), of which every third has no value.
struct Block {
    static constexpr std::size_t trials = 13, stride = 16;
    alignas(64) std::array<double, inputs_count * stride> in{};
    alignas(64) std::array<double, 3 * stride> out{};
    std::array<std::uint8_t, stride> valid{};

    Block() {
        for (std::size_t i = 0; i < inputs_count; ++i)
            for (std::size_t t = 0; t < stride; ++t)
                in[i * stride + t] = std::sin(1.0 + double(3 * i + 5 * t));
        for (std::size_t t = 0; t < stride; ++t) {
            double& x = in[stride + t];
            x = t % 3 == 0 ? -std::abs(x) : std::abs(x);
        }
    }
    void run(const MeasurementModel& model) {
        model.evaluate_block({in.data(), out.data(), valid.data(), stride, trials});
    }
    std::vector<double> trial(std::size_t t) const {
        std::vector<double> x(inputs_count);
        for (std::size_t i = 0; i < inputs_count; ++i) x[i] = in[i * stride + t];
        return x;
    }
};

void expect_block_equals_trials(const MeasurementModel& model) {
    Block block;
    block.run(model);
    for (std::size_t t = 0; t < Block::trials; ++t) {
        std::array<double, 3> y{};
        ASSERT_EQ(model.evaluate(block.trial(t), y), block.valid[t] == 1) << t;
        EXPECT_EQ(block.valid[t] == 1, t % 3 != 0);
        if (block.valid[t] == 0) continue;
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_NEAR(block.out[j * Block::stride + t], y[j], 1e-14 * std::max(1.0, std::abs(y[j]))) << t;
    }
}

TEST(EquationModel, ABlockEqualsItsTrials) {
    expect_block_equals_trials(ThreeForms{});
}

TEST(MeasurementModelDefaults, ABlockEqualsItsTrials) {
    expect_block_equals_trials(OneForm{});
}

TEST(EquationModel, TheJacobianIsExactAndDefaultDifferencesAgree) {
    const Block block;
    const std::vector<double> x = block.trial(1);
    Eigen::MatrixXd exact, differences;
    ASSERT_TRUE(ThreeForms{}.jacobian(x, exact));
    ASSERT_TRUE(OneForm{}.jacobian(x, differences));
    for (std::size_t i = 0; i < inputs_count; ++i)
        EXPECT_DOUBLE_EQ(exact(0, static_cast<Eigen::Index>(i)), 2.0 * double(i + 1) * x[i]);
    EXPECT_DOUBLE_EQ(exact(1, 10), std::sqrt(x[1]));
    EXPECT_LT((exact - differences).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(MeasurementModelDefaults, DifferencesOfAnAngleGoTheShortWayRound) {
    std::vector<double> x(inputs_count, 1.0);
    x[0] = 0.0;
    x[9] = -1.0;  // the angle is pi: a step to either side changes its sign
    Eigen::MatrixXd jacobian;
    ASSERT_TRUE(OneForm{}.jacobian(x, jacobian));
    EXPECT_NEAR(jacobian(2, 0), -1.0, 1e-9);
}

TEST(EquationModel, AValueThatIsNotFiniteMakesTheTrialInvalid) {
    const ThreeForms model;
    std::vector<double> x(inputs_count, 1.0);
    std::array<double, 3> y{};
    EXPECT_TRUE(model.evaluate(x, y));
    x[10] = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(model.evaluate(x, y));
    Block block;
    block.in[4 * Block::stride + 2] = std::numeric_limits<double>::quiet_NaN();
    block.run(model);
    EXPECT_EQ(block.valid[2], 0);
    EXPECT_EQ(block.valid[1], 1);
    EXPECT_EQ(block.valid[4], 1);
}

TEST(EquationModel, NoJacobianWhereThereIsNoValue) {
    std::vector<double> x(inputs_count, 1.0);
    x[1] = -1.0;
    Eigen::MatrixXd jacobian;
    EXPECT_FALSE(ThreeForms{}.jacobian(x, jacobian));
    EXPECT_FALSE(OneForm{}.jacobian(x, jacobian));
}

}  // namespace
}  // namespace covaria::equation_model_test
