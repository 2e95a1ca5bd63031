// The joint covariance of points, of outputs, of inputs and across both.
#include "core/result/joint_covariance.h"
#include "tests/core/result/changed_inputs.h"

#include <gtest/gtest.h>

#include <limits>

namespace covaria::joint_covariance_test {
namespace {

using Kind = PointCoordinates::Kind;

constexpr double u[] = {1e-3, 2e-3, 3e-3, 5e-3};

/// Inputs x0 ... x2 with a component of their own; component 3 is shared by x0 and x1. Outputs y_i = x_i + 2
/// x_0.
UncertaintyResult a_result() {
    UncertaintyResult result;
    InputSet inputs;
    for (const double standard : u) {
        UncertaintyComponent component;
        component.distribution = Distribution::normal(standard);
        inputs.components.push_back(component);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        InputQuantity quantity;
        quantity.shares = {{i, 1.0}};
        if (i < 2) quantity.shares.push_back({3, 0.5});
        inputs.quantities.push_back(quantity);
    }
    result.inputs = std::move(inputs);
    result.outputs.resize(3);
    result.budget.rows = {
        {{0, 3.0}, {3, 1.5}}, {{0, 2.0}, {1, 1.0}, {3, 1.5}}, {{0, 2.0}, {2, 1.0}, {3, 1.0}}};
    Eigen::MatrixXd c(3, 4);
    c << 3, 0, 0, 1.5, 2, 1, 0, 1.5, 2, 0, 1, 1;
    const Eigen::Vector4d variances(u[0] * u[0], u[1] * u[1], u[2] * u[2], u[3] * u[3]);
    result.covariance = Eigen::MatrixXd(c * variances.asDiagonal() * c.transpose());
    return result;
}

const PointCoordinates inputs{Kind::inputs, {0, 1, 2}};
const PointCoordinates outputs{Kind::outputs, {0, 1, 2}};

TEST(JointCovariance, OfOutputsIsThatOfTheResult) {
    UncertaintyResult result = a_result();
    result.covariance.whole()(0, 1) = result.covariance.whole()(1, 0) = 7e-6;  // found by Monte Carlo
    const auto V = JointCovariance(result).of({outputs, {Kind::outputs, {2, 0, 1}}});
    ASSERT_TRUE(V);
    EXPECT_EQ((*V)(0, 1), 7e-6);
    EXPECT_EQ((*V)(0, 5), 7e-6);
    EXPECT_EQ((*V)(3, 3), result.covariance(2, 2));
}

TEST(JointCovariance, OfInputsHasWhatTheyShare) {
    const UncertaintyResult result = a_result();
    const auto V = JointCovariance(result).of({inputs});
    ASSERT_TRUE(V);
    EXPECT_DOUBLE_EQ((*V)(0, 0), 1e-6 + 0.25 * 25e-6);
    EXPECT_DOUBLE_EQ((*V)(0, 1), 0.25 * 25e-6);
    EXPECT_EQ((*V)(0, 2), 0.0);
}

TEST(JointCovariance, OfInputsAndOutputsGoesThroughTheirComponents) {
    const UncertaintyResult result = a_result();
    const auto V = JointCovariance(result).of({outputs, inputs});
    ASSERT_TRUE(V);
    EXPECT_TRUE((V->topLeftCorner<3, 3>().isApprox(result.covariance.whole(), 1e-12)))
        << "the law of propagation from the budget";
    EXPECT_NEAR((*V)(1, 3), 2 * 1e-6 + 1.5 * 0.5 * 25e-6, 1e-18);
    EXPECT_TRUE(V->isApprox(V->transpose()));
}

TEST(JointCovariance, CorrelationsAndHeldComponentsCount) {
    UncertaintyResult result = a_result();
    test::change_inputs(result, [](InputSet& set) {
        set.correlations = {{0, 2, -0.5}};
        set.components[3].held = true;
    });
    const auto V = JointCovariance(result).of({inputs});
    ASSERT_TRUE(V);
    EXPECT_DOUBLE_EQ((*V)(0, 0), 1e-6);
    EXPECT_NEAR((*V)(0, 2), -0.5 * 1e-3 * 3e-3, 1e-18);
}

TEST(JointCovariance, IsAlongTheAxesOfW) {
    const UncertaintyResult result = a_result();
    PointCoordinates turned = inputs;
    turned.R_WQ << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // x of the quantities is y of W
    const auto V = JointCovariance(result).of({turned}), own = JointCovariance(result).of({inputs});
    ASSERT_TRUE(V && own);
    EXPECT_DOUBLE_EQ((*V)(1, 1), (*own)(0, 0));
    EXPECT_DOUBLE_EQ((*V)(0, 0), (*own)(1, 1));
    EXPECT_DOUBLE_EQ((*V)(0, 1), -(*own)(0, 1));
}

TEST(JointCovariance, IsEmptyWhereItIsNotKnown) {
    UncertaintyResult result = a_result();
    EXPECT_FALSE(JointCovariance(result).of({{Kind::outputs, {0, 1, 3}}})) << "no such output";
    result.covariance.whole()(1, 1) = std::numeric_limits<double>::infinity();  // found by Monte Carlo
    EXPECT_FALSE(JointCovariance(result).of({outputs}));
    EXPECT_TRUE(JointCovariance(result).of({{Kind::outputs, {0, 0, 2}}})) << "an infinite u elsewhere";
}

}  // namespace
}  // namespace covaria::joint_covariance_test
