// Set-ups of "pose from points": what is refused, what is warned of, other frames, conventions and modes.
#include <gtest/gtest.h>

#include <numbers>

#include "core/math/rotation.h"
#include "core/propagation/engine.h"
#include "tests/core/kinds/pose/stewart.h"

namespace covaria::pose_setup_test {
namespace {

using namespace stewart;

SetupTable& table(Setup& s, const std::string& key) {
    return std::get<SetupTable>(s.values[key]);
}

Problems problems_of(const Setup& s) {
    Problems problems;
    make(s, problems);
    return problems;
}

void expect_problem(const Setup& s, Severity severity, const std::string& path, const std::string& words) {
    const Problems problems = problems_of(s);
    for (const Problem& p : problems.items())
        if (p.severity == severity && p.path == path && p.message.english().find(words) != std::string::npos)
            return;
    ADD_FAILURE() << "no problem at " << path << " with '" << words << "'; there are "
                  << problems.items().size()
                  << (problems.empty() ? ""
                                       : ": " + problems.items().front().path + " " +
                                             problems.items().front().message.english());
}

UncertaintyResult first_order(const MeasurementModel& model) {
    return evaluate_first_order(model, model.inputs(), {}).value();
}

std::vector<double> values(const MeasurementModel& model) {
    std::vector<double> y(model.outputs().size());
    EXPECT_TRUE(model.evaluate(estimates(model.inputs()), y));
    return y;
}

// One pose, as a set-up of its own.
covaria::Setup one_pose(const std::array<double, 6>& pose) {
    covaria::Setup s = setup();
    s.values["poses"] = poses_table({pose});
    return s;
}

TEST(PoseSetup, TheStewartPlatformHasNoProblems) {
    EXPECT_TRUE(problems_of(setup()).empty());
    const auto model = make(setup());
    EXPECT_EQ(model->inputs().quantities.size(), 126u);
    EXPECT_EQ(model->inputs().components.size(), 126u);
    EXPECT_EQ(model->outputs().size(), 78u);
    EXPECT_EQ(model->outputs()[36].group, "pose 7");
}

TEST(PoseSetup, EstimatesAreTheNominalPoses) {
    const std::vector<double> y = values(*make(setup()));
    for (std::size_t k = 0; k < 13; ++k)
        for (std::size_t j = 0; j < 6; ++j)
            EXPECT_NEAR(y[6 * k + j], table_3[k][j] * (j < 3 ? 1e-3 : std::numbers::pi / 180), 1e-9);
}

TEST(PoseSetup, DegeneratePointsAreRefused) {
    covaria::Setup s = setup();
    table(s, "base_points").rows[2] = {std::string("b3"), 10.0, 196.0, 0.0, {}, {}, {}};
    expect_problem(s, Severity::error, "/base_points/rows/2",
                   "point b3 lies on the line through b1 and b2: the base frame is undefined");
    s = setup();
    table(s, "moving_points").rows[1] = {std::string("p2"), -196.0, -111.0, 0.0, {}, {}, {}};
    expect_problem(s, Severity::error, "/moving_points/rows/2", "points p1 and p2 coincide");
    s.values["moving_fit"] = std::string("least-squares");
    expect_problem(s, Severity::error, "/moving_points", "on one line or coincide");
    s = setup();
    table(s, "base_points").rows.pop_back();
    expect_problem(s, Severity::error, "/base_points", "at least 3 rows");
}

TEST(PoseSetup, NamesAreUnique) {
    covaria::Setup s = setup();
    table(s, "base_points").rows[1][0] = std::string("b1");
    expect_problem(s, Severity::error, "/base_points/rows/1/name", "two points called 'b1'");
    s = setup();
    table(s, "poses").rows[4][0] = std::string("pose 1");
    expect_problem(s, Severity::error, "/poses/rows/4/name", "two poses called 'pose 1'");
}

TEST(PoseSetup, NegativeUncertaintiesAreRefused) {
    covaria::Setup s = setup();
    s.values["base_u_x"] = mm(-0.066);
    expect_problem(s, Severity::error, "/base_u_x", "at least 0");
    s = setup();
    table(s, "moving_points").rows[0][5] = -1.0;
    expect_problem(s, Severity::error, "/moving_points/rows/0/u_y", "at least 0");
}

TEST(PoseSetup, WarnsOfLargeUncertaintiesGimbalLockAndOtherAxes) {
    expect_problem(setup(base_688, platform_392, {.066, .110, 70.0}), Severity::warning, "/base_points",
                   "more than a tenth");
    expect_problem(one_pose({0, 0, 1000, 0, 89.5, 0}), Severity::warning, "/poses/rows/0", "gimbal lock");
    covaria::Setup s = setup();
    s.values["base_third_point"] = std::string("positive-y");
    expect_problem(s, Severity::warning, "/base_points", "away from the axes in which they are given");
    s = setup();
    s.values["orientation"] = std::string("zyz");
    expect_problem(s, Severity::warning, "/poses/rows/2", "Z-Y-X angles");
    s = one_pose({0, 0, 1000, 0, 0, 179});
    s.values["orientation"] = std::string("quaternion");
    expect_problem(s, Severity::warning, "/poses/rows/0", "half a turn");
    s = setup();
    table(s, "base_points").rows.push_back({std::string("b4"), 0.0, 0.0, 0.0, {}, {}, {}});
    expect_problem(s, Severity::warning, "/base_points/rows/3", "uses the first three points");
}

// Differences of axes made from points are judged by the size of the whole figure, whichever points
// coincide.
TEST(PoseSetup, WarnsOfOtherAxesOnlyWhereThereAreOthers) {
    const Points figures[] = {{{0, 0, 0}, {0, 0, 0}, {1000, 0, 0}, {0, 900, 0}},
                              {{0, 0, 0}, {1000, 0, 0}, {1000, 0, 0}, {0, 900, 0}},
                              {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}, {1000, 0, 0}, {0, 900, 0}},
                              {{1000, 0, 0}, {0, 900, 0}, {0, 0, 0}, {0, 0, 0}}};
    for (const Points& figure : figures) {
        covaria::Setup s = setup(figure, figure, {.1, .1, .1}, .1);
        s.values["base_fit"] = s.values["moving_fit"] = std::string("least-squares");
        const Problems problems = problems_of(s);
        for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ' ' << p.message.english();
    }
}

TEST(PoseSetup, AnyFrame0GivesTheSameUncertainties) {
    covaria::Setup s = setup();
    PoseValue base;
    base.position = {12000, -7000, 1500};
    base.angles = {20, -35, 137};
    s.values["base_pose"] = base;
    const auto moved = make(s), fixed = make(setup());
    const UncertaintyResult a = first_order(*moved), b = first_order(*fixed);
    for (std::size_t j = 0; j < 78; ++j) {
        EXPECT_NEAR(a.outputs[j].estimate, b.outputs[j].estimate, 1e-12);
        EXPECT_NEAR(a.outputs[j].standard_uncertainty, b.outputs[j].standard_uncertainty,
                    1e-10 * b.outputs[j].standard_uncertainty);
    }
}

TEST(PoseSetup, HalfATurnIsTreatedOnTheCircle) {
    const auto model = make(one_pose({0, 0, 1175, 0, 0, 180}));
    EvaluationOptions options;
    options.trials = 100'000;
    const UncertaintyResult r = evaluate(*model, model->inputs(), options).value();
    const MonteCarloOutput& gamma = *r.outputs[5].monte_carlo;
    EXPECT_NEAR(std::abs(std::remainder(gamma.mean, 2 * std::numbers::pi)), std::numbers::pi,
                4 * gamma.standard_error_of_mean);
    EXPECT_NEAR(expanded(r, 0, 5), expanded(r, 0, 5, true),
                4 * 2 * 180 / std::numbers::pi * gamma.standard_error_of_uncertainty);
}

// porath.md: at beta = 89.9 degrees first order gives 57.7 degrees, Monte Carlo 70.
TEST(PoseSetup, NearGimbalLockFirstOrderIsWrongAndTheRotationVectorIsNot) {
    covaria::Setup s = one_pose({0, 0, 1175, 0, 89.9, 0});
    const auto angles = make(s);
    EvaluationOptions options;
    options.trials = 100'000;
    const UncertaintyResult r = evaluate(*angles, angles->inputs(), options).value();
    EXPECT_NEAR(expanded(r, 0, 5, true), 57.7, .2);
    EXPECT_GT(expanded(r, 0, 5), 65.0);
    s.values["orientation"] = std::string("rotation-vector");
    EXPECT_TRUE(problems_of(s).empty());
    const auto vector = make(s);
    const UncertaintyResult v = evaluate(*vector, vector->inputs(), options).value();
    for (std::size_t j = 3; j < 6; ++j) {
        EXPECT_LT(expanded(v, 0, j), .3);
        EXPECT_NEAR(expanded(v, 0, j), expanded(v, 0, j, true),
                    4 * 2 * 180 / std::numbers::pi * v.outputs[j].monte_carlo->standard_error_of_uncertainty);
    }
}

TEST(PoseSetup, AQuaternionHasFourCoordinates) {
    covaria::Setup s = one_pose({0, 0, 1175, 10, 20, 30});
    s.values["orientation"] = std::string("quaternion");
    const auto model = make(s);
    ASSERT_EQ(model->outputs().size(), 7u);
    const std::vector<double> y = values(*model);
    EXPECT_NEAR(y[3] * y[3] + y[4] * y[4] + y[5] * y[5] + y[6] * y[6], 1.0, 1e-14);
}

TEST(PoseSetup, SingleCoordinatesMayHaveTheirOwnUncertainty) {
    covaria::Setup s = setup(base_688, platform_392, {.1, .1, .1});
    table(s, "base_points").rows[1][6] = 0.7;
    const auto model = make(s);
    const InputSet& inputs = model->inputs();
    EXPECT_NEAR(standard_uncertainty_of(inputs, inputs.find("b_2z")), .7e-3, 1e-15);
    EXPECT_NEAR(standard_uncertainty_of(inputs, inputs.find("b_2y")), .1e-3, 1e-15);
}

TEST(PoseSetup, CommonDeviationsOfTheBaseMoveItAsAWhole) {
    covaria::Setup s = setup(base_688, platform_392, {.1, .2, .3}, 0.0);
    for (const char* key : {"base_common_x", "base_common_y", "base_common_z"}) s.values[key] = true;
    const auto model = make(s);
    EXPECT_EQ(model->inputs().components.size(), 3u + 13 * 9);
    const UncertaintyResult r = first_order(*model);
    EXPECT_NEAR(expanded(r, 2, 0, true), .2, 1e-12);
    EXPECT_NEAR(expanded(r, 2, 1, true), .4, 1e-12);
    EXPECT_NEAR(expanded(r, 2, 2, true), .6, 1e-12);
    EXPECT_NEAR(expanded(r, 2, 3, true), .0, 1e-12);
}

TEST(PoseSetup, LeastSquaresOfThreePointsKnowsThePlane) {
    covaria::Setup s = setup();
    s.values["base_fit"] = s.values["moving_fit"] = std::string("least-squares");
    const auto fitted = make(s), by_3_2_1 = make(setup());
    const std::vector<double> y = values(*fitted), expected = values(*by_3_2_1);
    for (std::size_t j = 0; j < y.size(); ++j) EXPECT_NEAR(y[j], expected[j], 1e-12);
    const UncertaintyResult a = first_order(*fitted), b = first_order(*by_3_2_1);
    EXPECT_LT(a.outputs[0].standard_uncertainty, b.outputs[0].standard_uncertainty);
    EXPECT_NEAR(a.outputs[2].standard_uncertainty, b.outputs[2].standard_uncertainty, 1e-9);  // same plane
}

// n points on a circle, u in every coordinate: u(o) = u/sqrt(n) each, u(gamma) = u/(r sqrt(n)) exactly.
TEST(PoseSetup, MorePointsMakeTheFrameBetter) {
    Points circle;
    for (int i = 0; i < 8; ++i)
        circle.push_back(
            {300 * std::cos(i * std::numbers::pi / 4), 300 * std::sin(i * std::numbers::pi / 4), 0});
    covaria::Setup s = setup(circle, circle, {0, 0, 0}, .1);
    s.values["base_fit"] = s.values["moving_fit"] = std::string("least-squares");
    EXPECT_TRUE(problems_of(s).empty());
    const auto model = make(s);
    EvaluationOptions options;
    options.trials = 20'000;
    const UncertaintyResult r = evaluate(*model, model->inputs(), options).value();
    EXPECT_EQ(r.failed_trials, 0u);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(expanded(r, 2, j, true), .2 / std::sqrt(8.0), 1e-12);
    EXPECT_NEAR(r.outputs[17].first_order.standard_uncertainty, .1 / 300 / std::sqrt(8.0), 1e-12);
    EXPECT_NEAR(r.outputs[15].first_order.standard_uncertainty, .1 / 300 / std::sqrt(4.0), 1e-12);
    for (std::size_t j = 12; j < 18; ++j)
        EXPECT_NEAR(r.outputs[j].monte_carlo->standard_uncertainty,
                    r.outputs[j].first_order.standard_uncertainty,
                    4 * r.outputs[j].monte_carlo->standard_error_of_uncertainty);
}

// Base and one pose measured twice in a frame 0 that is yawed and shifted.
covaria::Setup measured() {
    covaria::Setup s = one_pose({0, 0, 1175, 5, 5, 5});
    s.values["evaluation"] = std::string("a-posteriori");
    SetupTable rows = empty_table("measured_points");
    const double yaw = 37 * std::numbers::pi / 180, five = 5 * std::numbers::pi / 180;
    const Matrix3<double> R_0b = rotation_z(yaw), R_bp = rotation_from_zyx<double>({five, five, five});
    const Eigen::Vector3d o_0b(2000, -500, 300), o_bp(0.2, -0.1, 1175);
    for (double repeat : {1.0, 2.0})
        for (std::size_t i = 0; i < 3; ++i) {
            const double offset = repeat == 1.0 ? .05 : -.05;  // means are exact
            const Eigen::Vector3d b = R_0b * Eigen::Vector3d(base_688[i].data()) + o_0b;
            const Eigen::Vector3d p = R_0b * (R_bp * Eigen::Vector3d(platform_392[i].data()) + o_bp) + o_0b;
            const std::string n = std::to_string(i + 1);
            rows.rows.push_back({std::string("base"), "b" + n, repeat, b.x() + offset, b.y(), b.z()});
            rows.rows.push_back({std::string("pose 1"), "p" + n, repeat, p.x(), p.y() - offset, p.z()});
        }
    s.values["measured_points"] = rows;
    return s;
}

TEST(APosteriori, TheMeansAreTheEstimates) {
    EXPECT_TRUE(problems_of(measured()).empty());
    const auto model = make(measured());
    const std::vector<double> y = values(*model);
    EXPECT_NEAR(y[0], .2e-3, 1e-12);
    EXPECT_NEAR(y[1], -.1e-3, 1e-12);
    EXPECT_NEAR(y[2], 1.175, 1e-12);
    for (std::size_t j = 3; j < 6; ++j) EXPECT_NEAR(y[j], 5 * std::numbers::pi / 180, 1e-12);
    const UncertaintyResult r = first_order(*model);
    const std::array<double, 6> U{.735, .627, .301, .101, .101, .101};  // porath.md
    for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(expanded(r, 0, j, true), U[j], .003 * U[j] + .0005);
}

TEST(APosteriori, EveryPointMustBeMeasuredAndKnown) {
    covaria::Setup s = measured();
    auto& rows = table(s, "measured_points").rows;
    std::erase_if(rows, [](const auto& row) { return std::get<std::string>(row[1]) == "p2"; });
    expect_problem(s, Severity::error, "/measured_points", "point p2 of 'pose 1' was not measured");
    s = measured();
    table(s, "measured_points").rows[3][0] = std::string("pose 9");
    expect_problem(s, Severity::error, "/measured_points/rows/3/set",
                   "neither 'base' nor the name of a pose");
    s = measured();
    table(s, "measured_points").rows[2][1] = std::string("q");
    expect_problem(s, Severity::error, "/measured_points/rows/2/point", "no point called 'q'");
}

covaria::Setup from_asset() {
    covaria::Setup s = setup();
    for (const std::string prefix : {"base", "moving"}) {
        s.values[prefix + "_uncertainty"] = std::string("asset");
        s.values[prefix + "_asset"] = std::string("a");
    }
    return s;
}

TEST(PoseFromAssets, SystematicPartsAreSharedByAllPointsOfTheArtefact) {
    covaria::Setup bar{
        {{"length", mm(1000)}, {"evaluation", std::string("components")}, {"systematic_common", true}}};
    SetupTable components;
    components.units = std::vector<Unit>(4, Unit::of("mm"));
    components.units.emplace_back();
    components.rows = {{.01, .02, .1, .2, {}}};
    bar.values["components"] = components;
    const auto model = make(from_asset(), library_of("length-standard", bar));
    const InputSet& inputs = model->inputs();
    EXPECT_EQ(inputs.components.size(), 126u + 9u);
    const double u = 1e-3 * std::sqrt(.01 * .01 + .02 * .02 + .1 * .1 + .2 * .2);
    EXPECT_NEAR(standard_uncertainty_of(inputs, inputs.find("b_1x")), u, 1e-12);
    EXPECT_NEAR(standard_uncertainty_of(inputs, inputs.find("p_2y_13")), u, 1e-12);
    // Common to base and platform, parallel frames: the difference of two points keeps only the variability.
    const UncertaintyResult r = first_order(*model);
    const auto own = make(setup(base_688, platform_392, {.1, .1, .1}, .1));
    const UncertaintyResult only_own = first_order(*own);
    for (std::size_t j = 12; j < 18; ++j)
        EXPECT_NEAR(r.outputs[j].standard_uncertainty, only_own.outputs[j].standard_uncertainty, 1e-12);
}

TEST(PoseFromAssets, AnInstrumentStandsInThePicture) {
    PoseValue station;
    station.position = {-3500, 800, 500};
    const auto model =
        make(from_asset(), library_of("spherical-instrument", covaria::Setup{{{"station", station}}}));
    const Layout layout = model->layout(estimates(model->inputs()));
    EXPECT_EQ(layout.bodies.back().glyph, "total-station");
    EXPECT_LT((layout.bodies.back().X_WB.translation() - Eigen::Vector3d(-3.5, .8, .5)).norm(), 1e-15);
    EXPECT_EQ(layout.bodies.size(), 15u);  // once, though base and platform both refer to it
}

TEST(PoseFromAssets, AMissingAssetIsNamed) {
    Problems problems;
    EXPECT_EQ(make(from_asset(), problems), nullptr);
    EXPECT_EQ(problems.items().front().path, "/base_asset");
}

TEST(PoseLayout, TheOriginFollowsTheInputs) {
    const auto model = make(setup());
    std::vector<double> x = estimates(model->inputs());
    const std::size_t first = model->inputs().find("p_1x_3");
    for (std::size_t i = 0; i < 3; ++i) x[first + 3 * i] += 0.5;
    const Layout layout = model->layout(x);
    for (const LayoutPoint& p : layout.points)
        if (p.group == "pose 3" && p.outputs) {
            EXPECT_LT((p.p_W - Eigen::Vector3d(.5, 0, 1.175)).norm(), 1e-12);
            EXPECT_EQ(p.source.path, "/poses/rows/2");
        }
    EXPECT_EQ(layout.frames.size(), 14u);
    EXPECT_EQ(layout.bodies.size(), 14u);
    EXPECT_EQ(layout.points.size(), 3u + 13 * 4);
}

}  // namespace
}  // namespace covaria::pose_setup_test
