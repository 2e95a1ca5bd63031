// Bodies made from figures: arms, instruments on tripods, plates on feet, and the shadow they throw.
#include "viz/scene/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/viz/stewart_scene.h"
#include "viz/scene/build_scene.h"
#include "viz/scene/contact_shadow.h"

namespace covaria::solids_test {
namespace {

/// A column, an upper arm and a forearm with a tool; three joints, two of them across.
Layout arm() {
    Layout layout;
    const Eigen::Vector3d foot(0, 0, 0), shoulder(0, 0, 0.5), elbow(0, 0, 1.2), wrist(0.8, 0, 1.2),
        tool(1.0, 0, 1.2);
    const auto link = [&](const char* name, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        layout.links.push_back({.name = name, .kind = LinkKind::robot_link, .from_W = from, .to_W = to});
    };
    link("link 1", foot, shoulder);
    link("link 2", shoulder, elbow);
    link("link 3", elbow, wrist);
    link("tool", wrist, tool);
    const auto axis = [&](const char* name, const Eigen::Vector3d& at, const Eigen::Vector3d& along) {
        layout.links.push_back({.name = name,
                                .kind = LinkKind::joint_axis,
                                .from_W = at - 0.15 * along,
                                .to_W = at + 0.15 * along});
    };
    axis("axis 1", foot, Eigen::Vector3d::UnitZ());
    axis("axis 2", shoulder, Eigen::Vector3d::UnitY());
    axis("axis 3", elbow, Eigen::Vector3d::UnitY());
    axis("elsewhere", {3, 3, 0}, Eigen::Vector3d::UnitZ());
    return layout;
}

const SceneLink& link_of(const Scene& scene, const std::string& name) {
    return *std::ranges::find(scene.links, "link:" + name,
                              [](const SceneLink& link) { return link.item.id; });
}

TEST(Arms, GetThinnerFromTheBaseToTheFlange) {
    const Layout layout = arm();
    const Scene scene = build_scene({.layout = &layout}, {});
    double before = 1.0;
    for (const char* name : {"link 1", "link 2", "link 3"}) {
        const SceneLink& link = link_of(scene, name);
        EXPECT_LE(link.radius, before) << name;
        EXPECT_LT(link.end_radius, link.radius) << name;
        EXPECT_GT(link.end_radius, 0.02) << name;
        before = link.end_radius;
    }
    EXPECT_TRUE(link_of(scene, "link 1").stands);
    EXPECT_FALSE(link_of(scene, "link 2").stands);
}

TEST(Arms, HaveADrumAtEachJoint) {
    const Layout layout = arm();
    const Scene scene = build_scene({.layout = &layout}, {});
    const SceneLink& shoulder = link_of(scene, "axis 2");
    EXPECT_GT(shoulder.radius, link_of(scene, "link 2").radius) << "it is seen beside the link";
    EXPECT_NEAR(std::abs((shoulder.to - shoulder.from).normalized().y()), 1.0, 1e-9) << "along its axis";
    EXPECT_LT(((shoulder.from + shoulder.to) / 2 - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-9);
    const SceneLink& turntable = link_of(scene, "axis 1");
    EXPECT_GT(((turntable.from + turntable.to) / 2).z(), 0.0) << "a collar on the column";
    EXPECT_EQ(link_of(scene, "elsewhere").radius, 0.0) << "no arm passes through it";
    EXPECT_TRUE(link_of(scene, "elsewhere").is_dashed);
    const auto solids = solids_of_links(scene);
    EXPECT_GE(std::ranges::count(solids, Material::joint, &Solid::material), 3);
    EXPECT_GE(std::ranges::count(solids, Material::robot, &Solid::material), 4);
}

/// A tracker that is far above the floor, and a target to its left.
Scene tracker_scene(double height) {
    static Layout layout;
    layout = {};
    LayoutBody body{.name = "tracker", .kind = BodyKind::instrument, .glyph = "tracker"};
    body.X_WB.translation() = Eigen::Vector3d(0, 0, height);
    layout.bodies.push_back(body);
    layout.points.push_back({.name = "t", .kind = PointKind::target, .p_W = {0, 4, 0}});
    layout.links.push_back({.name = "sight",
                            .kind = LinkKind::sight_line,
                            .from_W = body.X_WB.translation(),
                            .to_W = {0, 4, 0}});
    return build_scene({.layout = &layout}, {});
}

TEST(Floors, LieBelowEllipsoidsAndCloudsThatNothingRestsAmong) {
    auto setup = test::stewart_setup(200);
    setup.layout.bodies.clear();
    setup.layout.links.clear();
    SceneOptions options;
    options.magnification = 1e6;
    const Scene scene = build_scene(setup.source(), options);
    ASSERT_TRUE(scene.floor);
    ASSERT_FALSE(scene.ellipsoids.empty());
    ASSERT_FALSE(scene.clouds.empty());
    const double lowest_point = std::ranges::min(scene.points, {}, [](const ScenePoint& p) {
                                    return p.item.position.z();
                                }).item.position.z();
    double lowest = lowest_point;
    for (const SceneEllipsoid& ellipsoid : scene.ellipsoids)
        for (int i = 0; i < 3; ++i)
            lowest = std::min(lowest, ellipsoid.item.position.z() - std::abs(ellipsoid.axes(2, i)));
    EXPECT_LT(lowest, lowest_point - 0.1) << "the ellipsoids are as large as the whole";
    EXPECT_LE(*scene.floor, lowest);
    const auto standing = test::stewart_setup(200);
    const Scene plates = build_scene(standing.source(), options);
    EXPECT_GT(*plates.floor, *scene.floor) << "plates stay on the floor that they stand on";
}

TEST(Instruments, StandOnTheFloorAndLookAtTheirTargets) {
    const Scene scene = tracker_scene(1.6);
    ASSERT_TRUE(scene.floor);
    const SceneBody& body = scene.bodies.front();
    EXPECT_GT(body.sight.dot(Eigen::Vector3d(0, 4, -1.6).normalized()), 0.999);
    const auto solids = solids_of_bodies(scene);
    int feet = 0;
    double lowest = 1e9;
    for (const Solid& solid : solids) {
        lowest = std::min({lowest, solid.from.z(), solid.to.z()});
        feet += solid.material == Material::dark && std::abs(solid.from.z() - *scene.floor) < 1e-6;
    }
    EXPECT_EQ(feet, 3);
    EXPECT_GT(lowest, *scene.floor - 0.1 * body.size);
    const auto lens = std::ranges::find(solids, Material::lens, &Solid::material);
    ASSERT_NE(lens, solids.end());
    EXPECT_GT((lens->to - body.item.position).dot(body.sight), 0.2 * body.size);
    const auto low = solids_of_bodies(tracker_scene(0.0));
    EXPECT_LE(std::ranges::count(low, Material::leg, &Solid::material), 1) << "no room for a tripod";
}

TEST(Plates, AtTheBottomHaveFeetOnTheFloor) {
    const auto setup = test::stewart_setup(0);
    const Scene scene = build_scene(setup.source(), {});
    ASSERT_EQ(scene.bodies.size(), 2u);
    EXPECT_GT(scene.bodies[0].feet, 0.0);
    EXPECT_EQ(scene.bodies[1].feet, 0.0) << "in the air";
    int feet = 0;
    for (const Solid& solid : solids_of_bodies(scene))
        if (solid.material == Material::support) {
            ++feet;
            EXPECT_NEAR(solid.from.z(), *scene.floor, 1e-9);
        }
    EXPECT_EQ(feet, 3) << "of a triangle";
}

TEST(ContactShadow, IsDarkUnderTheFeetAndNowhereElse) {
    const auto setup = test::stewart_setup(0);
    const Scene scene = build_scene(setup.source(), {});
    const ContactShadow shadow = contact_shadow(scene);
    ASSERT_GT(shadow.cells, 0u);
    const auto at = [&](const Eigen::Vector3d& p) {
        const auto cell = [&](double x, double middle) {
            return static_cast<std::size_t>((x - middle + shadow.half) / (2 * shadow.half) *
                                            double(shadow.cells));
        };
        return shadow
            .darkness[cell(p.y(), shadow.middle.y()) * shadow.cells + cell(p.x(), shadow.middle.x())];
    };
    for (const Solid& solid : solids_of_bodies(scene)) {
        if (solid.material != Material::support) continue;
        EXPECT_GT(at(solid.from), 0.3);
    }
    EXPECT_LT(at(shadow.middle + Eigen::Vector3d(0.9 * shadow.half, 0, 0)), 0.02);
    EXPECT_EQ(contact_shadow(Scene{}).cells, 0u);
}

}  // namespace
}  // namespace covaria::solids_test
