// URDF import: the parameters give the same tool as the chain of the file, for arms of every kind of
// neighbouring axes; what is refused and why.
#include "core/assets/urdf.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/assets/registry.h"
#include "core/model/serial_robot.h"

namespace covaria::urdf_test {
namespace {

struct Joint {
    std::string type = "revolute";
    Eigen::Vector3d xyz, rpy, axis;
};

std::string three(const Eigen::Vector3d& v) {
    char text[128];
    std::snprintf(text, sizeof text, "%.17g %.17g %.17g", v.x(), v.y(), v.z());
    return text;
}

std::string joint_xml(const std::string& name, const Joint& j, const std::string& parent,
                      const std::string& child) {
    return "<joint name=\"" + name + "\" type=\"" + j.type + "\"><origin xyz=\"" + three(j.xyz) +
           "\" rpy=\"" + three(j.rpy) + "\"/><parent link=\"" + parent + "\"/><child link=\"" + child +
           "\"/><axis xyz=\"" + three(j.axis) +
           "\"/><limit lower=\"-2\" upper=\"1.5\" effort=\"1\" velocity=\"1\"/></joint>\n";
}

std::string urdf_of(const std::vector<Joint>& joints) {
    std::string xml = "<?xml version=\"1.0\"?>\n<robot name=\"Arm\">\n";
    for (std::size_t i = 0; i < joints.size(); ++i)
        xml += joint_xml("j" + std::to_string(i + 1), joints[i], "l" + std::to_string(i),
                         "l" + std::to_string(i + 1));
    return xml + "</robot>\n";
}

Eigen::Isometry3d origin_of(const Joint& j) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation() = j.xyz;
    X.linear() = (Eigen::AngleAxisd(j.rpy.z(), Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(j.rpy.y(), Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(j.rpy.x(), Eigen::Vector3d::UnitX()))
                     .toRotationMatrix();
    return X;
}

Eigen::Isometry3d tip_of(const std::vector<Joint>& joints, const std::vector<double>& q) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    std::size_t next = 0;
    for (const Joint& j : joints) {
        X = X * origin_of(j);
        if (j.type != "fixed") X = X * Eigen::AngleAxisd(q[next++], j.axis.normalized());
    }
    return X;
}

std::unique_ptr<Asset> made(const ImportedAsset& imported) {
    const AssetDescriptor* kind = find_asset_kind(imported.kind);
    Problems problems;
    check_setup(kind->schema, imported.setup, problems);
    auto asset = kind->create(SetupReader(kind->schema, imported.setup), AssetLibrary(), problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << " " << p.message;
    return asset;
}

void expect_same_tool(const std::vector<Joint>& joints) {
    const auto imported = import_urdf(urdf_of(joints));
    ASSERT_TRUE(imported) << imported.error().message;
    const auto asset = made(*imported);
    ASSERT_NE(asset, nullptr);
    const SerialRobotSource& robot = *asset->serial_robot();
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> q;
        for (std::size_t i = 0; i < robot.joints().size(); ++i)
            q.push_back(1.5 * std::sin(1.0 + 7.3 * static_cast<double>(i) + 2.1 * trial));
        const Eigen::Isometry3d expected = tip_of(joints, q);
        const Eigen::Isometry3d found = robot.X_WB() * link_frames(robot, q).back();
        EXPECT_LT((found.translation() - expected.translation()).norm(), 1e-10) << trial;
        EXPECT_LT((found.linear() - expected.linear()).norm(), 1e-10) << trial;
    }
}

const Eigen::Vector3d X = Eigen::Vector3d::UnitX(), Y = Eigen::Vector3d::UnitY(),
                      Z = Eigen::Vector3d::UnitZ(), O = Eigen::Vector3d::Zero();

TEST(Urdf, AnIndustrialArm) {  // intersecting and parallel axes, fixed flange and tool0
    expect_same_tool({{"revolute", {0, 0, .29}, O, Z},
                      {"revolute", O, O, Y},
                      {"revolute", {0, 0, .27}, O, Y},
                      {"revolute", {0, 0, .07}, O, X},
                      {"revolute", {.302, 0, 0}, O, Y},
                      {"revolute", {.072, 0, 0}, O, X},
                      {"fixed", O, {0, 1.5707963267948966, 0}, X}});
}

TEST(Urdf, AllAxesSkewAndOffset) {
    expect_same_tool({{"revolute", {.1, -.05, .3}, {.1, .2, .3}, Z},
                      {"continuous", {.02, .03, .4}, {-1.2, .3, .1}, {.1, .2, .9}},
                      {"revolute", {.3, .1, -.1}, {.5, -.4, 1.0}, {1, 1, 0}},
                      {"fixed", {.05, .05, .05}, {.3, .3, .3}, X},
                      {"revolute", {.1, .2, .1}, {1.5, .1, -.7}, {0, -1, .2}},
                      {"revolute", {0, .1, .2}, {.2, -1.4, .3}, X},
                      {"revolute", {.1, 0, .1}, {0, .9, .1}, Y},
                      {"fixed", {.01, .02, .2}, {.4, .5, .6}, X}});
}

TEST(Urdf, ThreeParallelAxesInARow) {
    expect_same_tool({{"revolute", {0, 0, .1625}, O, Z},
                      {"revolute", {0, .138, 0}, {0, 1.57, 0}, Y},
                      {"revolute", {0, -.131, .425}, O, Y},
                      {"revolute", {0, 0, .392}, {0, 1.57, 0}, Y},
                      {"revolute", {0, .127, 0}, O, Z},
                      {"revolute", {0, 0, .0997}, O, Y}});
}

TEST(Urdf, AxesThatOpposeAndAxesThatCoincide) {
    expect_same_tool({{"revolute", {0, 0, .4}, O, Z},
                      {"revolute", {.3, 0, .1}, O, {0, 0, -1}},
                      {"revolute", {.25, .1, 0}, {.0002, -.0001, 0}, Z},
                      {"revolute", {0, 0, .2}, O, Z},
                      {"fixed", {.1, 0, 0}, O, X}});
}

TEST(Urdf, LimitsAndNamesAreKept) {
    const auto imported = import_urdf(urdf_of({{"revolute", O, O, Z}, {"continuous", {.5, 0, 0}, O, Y}}));
    ASSERT_TRUE(imported);
    const auto asset = made(*imported);
    EXPECT_NEAR(asset->serial_robot()->joints()[0].low, -2.0, 1e-10);
    EXPECT_NEAR(asset->serial_robot()->joints()[0].high, 1.5, 1e-10);
    EXPECT_TRUE(std::isinf(asset->serial_robot()->joints()[1].high));
    EXPECT_EQ(imported->name, "Arm");
    EXPECT_NE(imported->notes.find("j1, j2"), std::string::npos);
}

TEST(Urdf, AGripperIsLeftOut) {
    std::string xml =
        urdf_of({{"revolute", O, O, Z}, {"revolute", {.5, 0, 0}, O, Y}, {"fixed", {.1, 0, 0}, O, X}});
    xml.insert(xml.find("</robot>"), joint_xml("finger", {"prismatic", O, O, X}, "l3", "finger_left"));
    const auto imported = import_urdf(xml);
    ASSERT_TRUE(imported) << imported.error().message;
    EXPECT_EQ(made(*imported)->serial_robot()->joints().size(), 2u);
}

std::string refusal(const std::string& xml, const std::string& tip = {}) {
    const auto imported = import_urdf(xml, tip);
    return imported ? "accepted" : imported.error().message;
}

TEST(Urdf, WhatIsNoArmIsRefusedWithItsReason) {
    using testing::Test;
    const auto expect = [](const std::string& words, const std::string& found) {
        EXPECT_NE(found.find(words), std::string::npos) << found;
    };
    expect("not readable as XML", refusal("<robot><joint></robot>"));
    expect("<robot> is missing", refusal("<sdf/>"));
    expect("expand them first", refusal("<robot><xacro:include filename=\"a\"/></robot>"));
    expect("no rotating joint", refusal("<robot name=\"a\"/>"));
    expect("a kind that a serial robot does not have", refusal(urdf_of({{"prismatic", O, O, X}})));
    expect("its axis has no direction", refusal(urdf_of({{"revolute", O, O, O}})));
    expect("at most 7", refusal(urdf_of(std::vector<Joint>(8, {"revolute", {.1, 0, 0}, O, Z}))));
    expect("no joint leads to a link called hand", refusal(urdf_of({{"revolute", O, O, Z}}), "hand"));
    std::string two = urdf_of({{"revolute", O, O, Z}});
    two.insert(two.find("</robot>"), joint_xml("k1", {"revolute", {0, 1, 0}, O, Z}, "l0", "m1"));
    expect("several arms of equal length", refusal(two));
    EXPECT_TRUE(import_urdf(two, "m1"));
}

}  // namespace
}  // namespace covaria::urdf_test
