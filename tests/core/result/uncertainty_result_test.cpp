// Groups and correlation matrices, with zero and tiny variances.
#include "core/result/uncertainty_result.h"

#include <gtest/gtest.h>

namespace covaria::uncertainty_result_test {
namespace {

OutputQuantity output(const std::string& symbol, const std::string& group) {
    OutputQuantity q;
    q.symbol = symbol;
    q.group = group;
    return q;
}

TEST(Result, GroupsKeepTheOrderOfAppearance) {
    const std::vector<OutputQuantity> outputs{output("x", "pose 2"), output("d", ""), output("y", "pose 2"),
                                              output("x", "pose 1")};
    EXPECT_EQ(groups_of(outputs), (std::vector<Name>{"pose 2", "", "pose 1"}));
    EXPECT_EQ(outputs_of_group(outputs, "pose 2"), (std::vector<std::size_t>{0, 2}));
    EXPECT_TRUE(outputs_of_group(outputs, "pose 3").empty());
}

TEST(Result, CorrelationOfCovariance) {
    Eigen::Matrix3d covariance;
    covariance << 4, -3, 0, -3, 9, 0, 0, 0, 0;
    const Eigen::MatrixXd r = correlation_of(covariance);
    EXPECT_DOUBLE_EQ(r(0, 1), -0.5);
    EXPECT_DOUBLE_EQ(r(1, 0), -0.5);
    EXPECT_EQ(r(2, 2), 1.0);
    EXPECT_EQ(r(2, 0), 0.0);
}

TEST(Result, CorrelationSurvivesTinyVariances) {
    Eigen::Matrix2d covariance;
    covariance << 1e-200, 0.5e-200, 0.5e-200, 1e-200;
    EXPECT_NEAR(correlation_of(covariance)(0, 1), 0.5, 1e-12);
}

}  // namespace
}  // namespace covaria::uncertainty_result_test
