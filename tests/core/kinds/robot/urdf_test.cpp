// URDF import: the parameters give the same tool as the chain of the file, for arms of every kind of
// neighbouring axes; what is refused and why.
#include "core/kinds/robot/urdf.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/kinds/registries.h"
#include "core/kinds/robot/serial_robot.h"

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
        if (j.type == "prismatic")
            X = X * Eigen::Translation3d(q[next++] * j.axis.normalized());
        else if (j.type != "fixed")
            X = X * Eigen::AngleAxisd(q[next++], j.axis.normalized());
    }
    return X;
}

std::unique_ptr<Asset> made(const ImportedAsset& imported) {
    const AssetDescriptor* kind = find_asset_kind(imported.kind);
    Problems problems;
    check_setup(kind->schema, imported.setup, problems);
    auto asset = kind->create(SetupReader(kind->schema, imported.setup), AssetLibrary(), problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << " " << p.message.english();
    return asset;
}

void expect_same_tool(const std::vector<Joint>& joints) {
    const auto imported = import_urdf(urdf_of(joints));
    ASSERT_TRUE(imported) << imported.error().message.english();
    const auto asset = made(*imported);
    ASSERT_NE(asset, nullptr);
    const SerialRobotSource& robot = *offers<SerialRobotSource>(asset);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> q;
        for (std::size_t i = 0; i < robot.joints().size(); ++i)
            q.push_back(1.4 * std::sin(1.0 + 7.3 * static_cast<double>(i) + 2.1 * trial));
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
    EXPECT_NEAR(offers<SerialRobotSource>(asset)->joints()[0].low, -2.0, 1e-10);
    EXPECT_NEAR(offers<SerialRobotSource>(asset)->joints()[0].high, 1.5, 1e-10);
    EXPECT_TRUE(std::isinf(offers<SerialRobotSource>(asset)->joints()[1].high));
    EXPECT_EQ(imported->name, "Arm");
    EXPECT_NE(imported->notes.find("j1, j2"), std::string::npos);
}

TEST(Urdf, AGripperIsLeftOut) {
    std::string xml =
        urdf_of({{"revolute", O, O, Z}, {"revolute", {.5, 0, 0}, O, Y}, {"fixed", {.1, 0, 0}, O, X}});
    xml.insert(xml.find("</robot>"), joint_xml("finger", {"prismatic", O, O, X}, "l3", "finger_left"));
    const auto imported = import_urdf(xml);
    ASSERT_TRUE(imported) << imported.error().message.english();
    EXPECT_EQ(offers<SerialRobotSource>(made(*imported))->joints().size(), 2u);
}

std::string refusal(const std::string& xml, const std::string& tip = {}) {
    const auto imported = import_urdf(xml, {.tip = tip});
    return imported ? "accepted" : imported.error().message.english();
}

TEST(Urdf, WhatIsNoArmIsRefusedWithItsReason) {
    using testing::Test;
    const auto expect = [](const std::string& words, const std::string& found) {
        EXPECT_NE(found.find(words), std::string::npos) << found;
    };
    expect("not readable as XML", refusal("<robot><joint></robot>"));
    expect("<robot> is missing", refusal("<sdf/>"));
    expect("expand them first", refusal("<robot><xacro:include filename=\"a\"/></robot>"));
    expect("no moving joint", refusal("<robot name=\"a\"/>"));
    expect("j1 is of the type planar", refusal(urdf_of({{"planar", O, O, X}})));
    expect("axis has no direction", refusal(urdf_of({{"prismatic", O, O, O}})));
    expect("its axis has no direction", refusal(urdf_of({{"revolute", O, O, O}})));
    expect("at most 7", refusal(urdf_of(std::vector<Joint>(8, {"revolute", {.1, 0, 0}, O, Z}))));
    expect("no joint leads to a link called hand", refusal(urdf_of({{"revolute", O, O, Z}}), "hand"));
    std::string two = urdf_of({{"revolute", O, O, Z}});
    two.insert(two.find("</robot>"), joint_xml("k1", {"revolute", {0, 1, 0}, O, Z}, "l0", "m1"));
    expect("several arms of equal length", refusal(two));
    EXPECT_TRUE(import_urdf(two, {.tip = "m1"}));
}

// The line is that of the element that cannot be, or where reading ended.
TEST(Urdf, WhatIsRefusedHasItsLine) {
    const auto line = [](const std::string& xml) {
        const auto imported = import_urdf(xml);
        return imported ? 0 : imported.error().line;
    };
    EXPECT_EQ(line("<robot>\n\n<joint>\n</robot>"), 4);
    EXPECT_EQ(line(""), 1);
    EXPECT_EQ(line("<?xml version=\"1.0\"?>\n<sdf/>"), 2);
    EXPECT_EQ(line("<robot>\n<link name=\"a\"/>\n<xacro:a/></robot>"), 3);
    EXPECT_EQ(line("\n\n<robot name=\"a\"/>"), 3);
    const Joint good{"revolute", {.1, 0, 0}, O, Z};
    EXPECT_EQ(line(urdf_of({good, {"revolute", O, O, O}})), 4);
    EXPECT_EQ(line(urdf_of({{"planar", O, O, X}})), 3);
    EXPECT_EQ(line(urdf_of(std::vector<Joint>(9, good))), 3 + 7);
    const auto and_joint = [&](const std::string& from, const std::string& to) {
        const std::string xml = urdf_of({good, good});
        return std::string(xml).insert(xml.find("</robot>"), joint_xml("k", good, from, to));
    };
    EXPECT_EQ(line(and_joint("l1", "l2")), 5) << "two joints hold one link";
    EXPECT_EQ(line(and_joint("l2", "")), 5);
    EXPECT_EQ(line(and_joint("l2", "l0")), 3) << "a ring";
    EXPECT_EQ(line(and_joint("l1", "m")), 5) << "two arms of equal length";
}

TEST(Urdf, SlidingJointsAnywhere) {
    expect_same_tool({{"prismatic", {.1, .2, 0}, O, Y},
                      {"revolute", {0, 0, .4}, O, Z},
                      {"revolute", {.3, 0, 0}, {0, .2, 0}, Y},
                      {"fixed", {.1, 0, 0}, {.3, 0, 0}, X},
                      {"prismatic", {.2, 0, .1}, {.1, .5, 0}, {1, .2, 0}},
                      {"revolute", {.1, 0, 0}, O, X}});
    expect_same_tool({{"revolute", {0, 0, .4}, O, Z},  // a SCARA: all axes parallel
                      {"revolute", {.3, 0, 0}, O, Z},
                      {"prismatic", {.25, 0, 0}, O, {0, 0, -1}},
                      {"revolute", O, O, Z}});
    expect_same_tool({{"prismatic", O, O, X}, {"prismatic", O, O, Y}, {"prismatic", O, O, Z}});
}

// Everything at right angles, where the angles of base and tool are in gimbal lock more often than not.
TEST(Urdf, ArmsAtRightAngles) {
    unsigned state = 12345;
    const auto pick = [&](int n) {
        state = state * 1664525u + 1013904223u;
        return static_cast<int>((state >> 16) % static_cast<unsigned>(n));
    };
    const double quarter = std::acos(0.0);
    const Eigen::Vector3d axes[] = {X, Y, Z, -X, -Y, -Z};
    for (int arm = 0; arm < 200; ++arm) {
        std::vector<Joint> joints;
        const int n = 1 + pick(6);
        for (int j = 0; j <= n; ++j) {
            const Eigen::Vector3d xyz(.1 * pick(4), .1 * (pick(3) - 1), .1 * pick(5));
            const Eigen::Vector3d rpy(quarter * (pick(4) - 1), quarter * (pick(3) - 1),
                                      quarter * (pick(4) - 1));
            joints.push_back({j == n                  ? "fixed"
                              : pick(5) == 0 && j < 2 ? "prismatic"
                                                      : "revolute",
                              xyz, rpy, axes[pick(6)]});
        }
        expect_same_tool(joints);
        if (HasFailure()) {
            ADD_FAILURE() << "arm " << arm;
            return;
        }
    }
}

std::string case_file(const char* name) {
    std::ifstream in(std::string(COVARIA_SOURCE_DIR "/tests/data/cases/") + name);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

TEST(Urdf, TheToolOfTheGimbalCaseStandsWhereTheFileSays) {
    const auto imported = import_urdf(case_file("gimbal.urdf"));
    ASSERT_TRUE(imported) << imported.error().message.english();
    const auto asset = made(*imported);
    const SerialRobotSource& robot = *offers<SerialRobotSource>(asset);
    const Eigen::Isometry3d tool = robot.X_WB() * link_frames(robot, {0.0}).back();
    EXPECT_LT((tool.translation() - Eigen::Vector3d(.2, .1, .15)).norm(), 1e-12);
    EXPECT_LT((tool.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-10);
}

bool reports(const ImportedAsset& imported, const std::string& words) {
    for (const Message& line : imported.report)
        if (line.english().find(words) != std::string::npos) return true;
    for (const Message& line : imported.report) std::printf("%s\n", line.english().c_str());
    return false;
}

const std::vector<Joint> six_axes{{"revolute", {0, 0, .3}, O, Z}, {"revolute", {.1, 0, .1}, O, Y},
                                  {"revolute", {0, 0, .4}, O, Y}, {"revolute", {.2, 0, 0}, O, X},
                                  {"revolute", {.2, 0, 0}, O, Y}, {"revolute", {.1, 0, 0}, O, X},
                                  {"fixed", {.1, 0, 0}, O, X}};

std::string with(std::string xml, const std::string& more) {
    return xml.insert(xml.find("</robot>"), more);
}

std::string mimicking(std::string joint, const std::string& driver) {
    return joint.insert(joint.find("<axis"), "<mimic joint=\"" + driver + "\"/>");
}

TEST(Urdf, NoGripperIsTakenForAJointAndTheReportSaysWhy) {
    const auto slider = [](const char* name, const char* parent, const char* child, double stroke) {
        std::string xml = joint_xml(name, {"prismatic", O, O, Y}, parent, child);
        const std::string limits = "lower=\"-2\" upper=\"1.5\"";
        return xml.replace(xml.find(limits), limits.size(),
                           "lower=\"0\" upper=\"" + std::to_string(stroke) + "\"");
    };
    struct Gripper {
        std::string xml, joint, why;
    };
    const Joint turning{"revolute", {0, .05, 0}, O, Z};
    const Gripper grippers[] = {
        {slider("slide", "l7", "tip_a", .05), "slide", "less than 100 mm"},
        {joint_xml("left_FINGER", turning, "l7", "tip_a"), "left_FINGER", "called like"},
        {joint_xml("drive", turning, "l7", "a") + mimicking(joint_xml("k", turning, "l7", "b"), "drive"),
         "drive", "others follow it"},
        {joint_xml("drive", turning, "l7", "a") + mimicking(joint_xml("k", turning, "l7", "b"), "drive"), "k",
         "follows joint drive"},
        {joint_xml("a1", turning, "l7", "a") + joint_xml("a2", turning, "a", "aa") +
             joint_xml("b1", turning, "l7", "b") + joint_xml("c1", turning, "l7", "c"),
         "a1", "as in a hand"}};
    for (const Gripper& gripper : grippers) {
        const auto imported = import_urdf(with(urdf_of(six_axes), gripper.xml));
        ASSERT_TRUE(imported) << imported.error().message.english();
        EXPECT_EQ(offers<SerialRobotSource>(made(*imported))->joints().size(), 6u) << gripper.joint;
        EXPECT_TRUE(reports(*imported, gripper.joint + ": left out: ")) << gripper.joint;
        EXPECT_TRUE(reports(*imported, gripper.why)) << gripper.joint;
        EXPECT_TRUE(reports(*imported, "6 joints from link l0 to link l7"));
    }
    const auto named = import_urdf(with(urdf_of(six_axes), grippers[1].xml), {.tip = "tip_a"});
    ASSERT_TRUE(named) << named.error().message.english();
    EXPECT_EQ(offers<SerialRobotSource>(made(*named))->joints().size(), 6u);
    EXPECT_TRUE(reports(*named, "left_FINGER: frozen"));
}

TEST(Urdf, ArmsThatOnlyLookLikeGrippersAreTaken) {
    std::vector<Joint> scara{{"revolute", O, O, Z},
                             {"revolute", {.3, 0, 0}, O, Z},
                             {"revolute", {.2, 0, 0}, O, Z},
                             {"prismatic", O, O, Z}};
    const auto quill = import_urdf(urdf_of(scara));  // slides by 3.5 m
    ASSERT_TRUE(quill);
    EXPECT_EQ(offers<SerialRobotSource>(made(*quill))->joints().size(), 4u);
    // A palletiser: passive links follow the joints of the arm.
    std::vector<Joint> four(six_axes.begin(), six_axes.begin() + 4);
    const auto palletiser =
        import_urdf(with(urdf_of(four), mimicking(joint_xml("rod", four[1], "l1", "rod_link"), "j2") +
                                            mimicking(joint_xml("bar", four[1], "l3", "bar_link"), "j3")));
    ASSERT_TRUE(palletiser) << palletiser.error().message.english();
    EXPECT_EQ(offers<SerialRobotSource>(made(*palletiser))->joints().size(), 4u);
}

TEST(Urdf, AJointBeforeTheArmIsFrozen) {
    std::vector<Joint> joints = six_axes;
    joints.insert(joints.begin(), {"prismatic", {.5, 0, 0}, {0, 0, .3}, Y});
    joints.insert(joints.begin(), {"revolute", {0, 0, .1}, O, Z});
    EXPECT_NE(refusal(urdf_of(joints)).find("8 moving joints; an arm has at most 7"), std::string::npos)
        << refusal(urdf_of(joints));
    const auto imported = import_urdf(urdf_of(joints), {.frozen = {{"j1", 90.0}, {"j2", 250.0}}});
    ASSERT_TRUE(imported) << imported.error().message.english();
    EXPECT_TRUE(reports(*imported, "j1: frozen at 90°"));
    EXPECT_TRUE(reports(*imported, "j2: frozen at 250 mm"));
    const auto asset = made(*imported);
    const SerialRobotSource& robot = *offers<SerialRobotSource>(asset);
    ASSERT_EQ(robot.joints().size(), 6u);
    const std::vector<double> q{.3, -.5, 1.1, .2, -.9, .4};
    std::vector<double> all{std::acos(0.0), .25};
    all.insert(all.end(), q.begin(), q.end());
    const Eigen::Isometry3d found = robot.X_WB() * link_frames(robot, q).back();
    EXPECT_LT((found.matrix() - tip_of(joints, all).matrix()).norm(), 1e-9);
    const auto unknown = import_urdf(urdf_of(joints), {.frozen = {{"j11", 0.0}}});
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.english().find("j11"), std::string::npos)
        << unknown.error().message.english();
    const auto beyond = import_urdf(urdf_of(joints), {.frozen = {{"j1", 170.0}}});
    ASSERT_TRUE(beyond);
    EXPECT_TRUE(reports(*beyond, "beyond its limits"));
}

TEST(Urdf, ThousandsOfJointsTakeNoTime) {
    std::vector<Joint> joints = six_axes;
    joints.insert(joints.begin(), 4000, {"fixed", {.001, 0, 0}, O, X});
    std::string xml = urdf_of(joints);
    std::string bush;
    for (int k = 0; k < 4000; ++k)
        bush += joint_xml("f" + std::to_string(k), {"fixed", O, O, X}, "l4005", "leaf" + std::to_string(k));
    const auto start = std::chrono::steady_clock::now();
    const auto imported = import_urdf(with(xml, bush));
    ASSERT_TRUE(imported) << imported.error().message.english();
    EXPECT_EQ(offers<SerialRobotSource>(made(*imported))->joints().size(), 6u);
    EXPECT_NE(refusal(urdf_of(std::vector<Joint>(4000, {"revolute", {.1, 0, 0}, O, Z}))).find("at most 7"),
              std::string::npos);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

}  // namespace
}  // namespace covaria::urdf_test
