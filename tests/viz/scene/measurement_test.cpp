// Measuring in the Stewart platform: what is picked, the values, and why a u is not stated.
#include "viz/scene/measurement.h"
#include "tests/core/result/changed_inputs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/viz/stewart_scene.h"

namespace covaria::measurement_test {
namespace {

constexpr PictureSize size{1280, 800};
const auto everything = [](Layer) { return true; };

class SceneMeasurement : public testing::Test {
protected:
    SceneMeasurement() {
        // dy_i/dx: the origin goes with the mean of the nests of the platform.
        setup_.result.budget.rows.resize(3);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t nest = 3; nest < 6; ++nest)
                setup_.result.budget.rows[i].push_back({3 * nest + i, 1.0 / 3});
        scene_ = build_scene(setup_.source(), {});
    }
    const Eigen::Vector3d& at(const char* id) const { return find_item(scene_, id)->position; }

    test::StewartSetup setup_ = test::stewart_setup(200);
    Scene scene_;
};

TEST_F(SceneMeasurement, PicksPointsAndOriginsOnly) {
    const Camera camera = view_of(bounds_of(scene_), StandardView::iso, size);
    const auto under = [&](const Eigen::Vector3d& p) {
        return place_at(scene_, camera, size, project(camera, size, p), everything);
    };
    EXPECT_EQ(under(at("point:b1")), "point:b1");
    EXPECT_EQ(under(at("frame:base b")), "frame:base b");
    EXPECT_EQ(under(at("point:platform origin")), "point:platform origin") << "before the frame there";
    EXPECT_EQ(under((at("point:p1") + at("point:p2")) / 2), std::nullopt) << "a plate is no place";
    EXPECT_EQ(place_at(scene_, camera, size, project(camera, size, at("point:b1")),
                       [](Layer layer) { return layer != Layer::points; }),
              std::nullopt)
        << "what is not shown";
}

TEST_F(SceneMeasurement, DistanceOfInputs) {
    const auto made = measure(scene_, &setup_.result, {"point:b1", "point:b2"});
    ASSERT_TRUE(made);
    EXPECT_DOUBLE_EQ(made->value, (at("point:b2") - at("point:b1")).norm());
    EXPECT_FALSE(made->is_angle());
    EXPECT_EQ(made->names, (std::vector<std::string>{"b1", "b2"}));
    ASSERT_TRUE(made->u);
    const Eigen::Vector3d e = (at("point:b2") - at("point:b1")).normalized();
    double variance = 0.0;
    for (std::size_t k = 0; k < 6; ++k) {
        const double u = setup_.result.inputs->components[k].distribution.standard_uncertainty();
        variance += std::pow(e[static_cast<Eigen::Index>(k % 3)] * u, 2);
    }
    EXPECT_NEAR(*made->u, std::sqrt(variance), 1e-12);
}

TEST_F(SceneMeasurement, AnInputAndAnOutputShareComponents) {
    const auto made = measure(scene_, &setup_.result, {"point:p1", "point:platform origin"});
    ASSERT_TRUE(made && made->u);
    const Eigen::Vector3d e = (at("point:platform origin") - at("point:p1")).normalized();
    double variance = 0.0;
    for (std::size_t k = 9; k < 18; ++k) {
        const double u = setup_.result.inputs->components[k].distribution.standard_uncertainty();
        const double c = k < 12 ? 1.0 / 3 - 1 : 1.0 / 3;
        variance += std::pow(c * e[static_cast<Eigen::Index>(k % 3)] * u, 2);
    }
    EXPECT_NEAR(*made->u, std::sqrt(variance), 1e-12);
}

TEST_F(SceneMeasurement, AngleAtTheSecondPlace) {
    const auto made = measure(scene_, &setup_.result, {"point:b1", "point:b2", "point:b3"});
    ASSERT_TRUE(made);
    EXPECT_TRUE(made->is_angle());
    const Eigen::Vector3d p = at("point:b1") - at("point:b2"), q = at("point:b3") - at("point:b2");
    EXPECT_NEAR(made->value, std::acos(p.normalized().dot(q.normalized())), 1e-12);
    EXPECT_TRUE(made->u && *made->u > 0);
}

TEST_F(SceneMeasurement, SaysWhyUIsNotStated) {
    const auto reason = [&](const UncertaintyResult* result, const char* from, const char* to) {
        const auto made = measure(scene_, result, {from, to});
        EXPECT_TRUE(made && !made->u && made->value > 0);
        return made ? made->reason : NotStated::none;
    };
    EXPECT_EQ(reason(nullptr, "point:b1", "point:b2"), NotStated::no_result);
    EXPECT_EQ(reason(&setup_.result, "point:b1", "frame:base b"), NotStated::no_quantities);
    EXPECT_EQ(measure(scene_, &setup_.result, {"point:b1", "frame:base b"})->place, "base b");
    UncertaintyResult constant = setup_.result;
    test::change_inputs(constant, [](InputSet& inputs) {
        for (std::size_t k = 3; k < 6; ++k) inputs.components[k].held = true;
    });
    EXPECT_EQ(reason(&constant, "point:b1", "point:b2"), NotStated::constant);
    EXPECT_EQ(measure(scene_, &constant, {"point:b1", "point:b2"})->place, "b2");
    UncertaintyResult unknown = setup_.result;
    unknown.covariance = {};
    unknown.budget.rows.clear();
    EXPECT_EQ(reason(&unknown, "point:b1", "point:platform origin"), NotStated::not_finite);
    const auto huge = test::stewart_setup(0, 1000.0);  // uncertainties as large as the platform
    EXPECT_EQ(reason(&huge.result, "point:b1", "point:b2"), NotStated::not_linear);
}

TEST_F(SceneMeasurement, NeedsTwoOrThreeItemsOfTheScene) {
    EXPECT_FALSE(measure(scene_, &setup_.result, {"point:b1"}));
    EXPECT_FALSE(measure(scene_, &setup_.result, {"point:b1", "point:nowhere"}));
}

}  // namespace
}  // namespace covaria::measurement_test
