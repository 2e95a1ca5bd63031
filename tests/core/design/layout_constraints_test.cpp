// Constraints in space, judged on layouts made by hand.
#include "core/design/layout_constraints.h"

#include <gtest/gtest.h>

#include <cmath>

namespace covaria::layout_constraints_test {
namespace {

using detail::judge_layout;

const Unit m = Unit::of("m");

/// Instruments S at the origin and T at (4, 0, 0), a target Q at (2, 2, 0), both see it.
Layout two_instruments() {
    Layout layout;
    const Eigen::Vector3d q(2, 2, 0);
    for (const auto& [name, x] : {std::pair{"S", 0.0}, {"T", 4.0}}) {
        Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
        X.translation() = Eigen::Vector3d(x, 0, 0);
        layout.bodies.push_back({.name = name, .kind = BodyKind::instrument, .X_WB = X});
        layout.points.push_back({.name = name, .kind = PointKind::station, .p_W = X.translation()});
        layout.links.push_back({.name = std::string(name) + " – Q",
                                .kind = LinkKind::sight_line,
                                .from_W = X.translation(),
                                .to_W = q});
    }
    layout.points.push_back({.name = "Q", .kind = PointKind::target, .p_W = q});
    return layout;
}

TEST(LayoutConstraints, LeastDistanceIsBetweenInstrumentsAndOfThemFromPoints) {
    Design design;
    design.least_distance = Quantity{2.8, m};
    EXPECT_EQ(judge_layout(two_instruments(), design).reason, "");
    design.least_distance = Quantity{2.9, m};  // sqrt(8) = 2.83 to the target
    EXPECT_EQ(judge_layout(two_instruments(), design).reason, "S and Q are closer than the least distance");
    Layout near = two_instruments();
    near.bodies[1].X_WB.translation().x() = near.points[1].p_W.x() = 2.0;
    design.least_distance = Quantity{1.99, m};  // all distances are 2 or more
    EXPECT_EQ(judge_layout(near, design).violation, 0.0);
    design.least_distance = Quantity{2.5, m};
    const auto verdict = judge_layout(near, design);
    EXPECT_NEAR(verdict.violation, 0.2 + 0.2, 1e-12);  // S – T and T – Q
}

TEST(LayoutConstraints, NoInstrumentStandsInABox) {
    Design design;
    design.keep_out = {{"pillar", {3, -1, -1}, {5, 1, 1}, m}};
    const auto verdict = judge_layout(two_instruments(), design);
    EXPECT_EQ(verdict.reason, "T stands in the box 'pillar'");
    EXPECT_NEAR(verdict.violation, 1.0 / std::sqrt(12.0), 1e-12);
    design.keep_out = {{"", {1, 1, -1}, {3, 3, 1}, m}};  // the target may
    EXPECT_EQ(judge_layout(two_instruments(), design).reason, "");
}

TEST(LayoutConstraints, NoLineOfSightPassesABox) {
    Design design;
    design.hidden_by = {{"wall", {0.5, 0, -1}, {1.5, 1, 1}, m}};  // cut from (0.5, 0.5) to (1, 1)
    const auto verdict = judge_layout(two_instruments(), design);
    EXPECT_EQ(verdict.reason, "the line of sight S – Q passes the box 'wall'");
    EXPECT_NEAR(verdict.violation, std::sqrt(0.5) / std::sqrt(6.0), 1e-12);
    design.hidden_by = {{"", {0.5, 0.5, 0.1}, {1.5, 1, 1}, m}};  // above
    EXPECT_EQ(judge_layout(two_instruments(), design).reason, "");
    design.hidden_by = {{"", {2.5, 2.5, -1}, {9, 9, 1}, m}};  // behind the target
    EXPECT_EQ(judge_layout(two_instruments(), design).reason, "");
}

TEST(LayoutConstraints, WhatALayoutCannotTellIsSaid) {
    Design design;
    EXPECT_EQ(detail::why_not_judged({}, design), "");
    design.hidden_by = {{"", {0, 0, 0}, {1, 1, 1}, m}};
    EXPECT_EQ(detail::why_not_judged(two_instruments(), design), "");
    EXPECT_NE(detail::why_not_judged({}, design).english().find("no lines of sight"), std::string::npos);
    design.hidden_by.clear();
    design.least_distance = Quantity{1, m};
    EXPECT_NE(detail::why_not_judged({}, design).english().find("no instruments"), std::string::npos);
}

}  // namespace
}  // namespace covaria::layout_constraints_test
