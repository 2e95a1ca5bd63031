// projects/er10l-c10.covaria, the robot of Wen et al., and variants of it: reference values computed
// independently (the paper prints none for the end effector), edge cases. Millimetres.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/kinds/robot/serial_robot.h"
#include "tests/core/kinds/robot/robot_project.h"
#include "tests/core/table_rows.h"

namespace covaria::robot_pose_test {
namespace {

using robot_test::Robot;
using robot_test::Row;

double four_errors(double trials, double other = 8e6) {
    return 4.0 * std::sqrt(0.5 / trials + 0.5 / other);
}

void expect_near(const Row& found, const Row& expected, double tolerance) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << i;
}

const std::optional<FirstOrderOutput::Validation>& m_validation(const UncertaintyResult& r, std::size_t i) {
    return r.outputs[i].first_order.validation;
}

// --- the zero pose, wen.md section 3

TEST(RobotPose, FirstOrderAtTheZeroPose) {
    Robot robot;
    const UncertaintyResult r = robot.run("zero-pose", 0);
    expect_near(robot_test::estimates(r), {1349.914155, 1.416990, 1431.103847}, 1e-6);
    expect_near(robot_test::u(r), {.527163, 1.368701, .593457}, 1e-6);
    expect_near(robot_test::covariance(r), {.277942, 1.873255, .352192, -.004090, -.060617, -.005382}, 2e-4);
}

TEST(RobotPose, NominalAtTheZeroPose) {
    Robot robot;
    const UncertaintyResult r = robot.run("zero-pose-nominal", 400'000);
    expect_near(robot_test::estimates_first_order(r), {1355, 0, 1424}, 1e-9);
    const Row u{.526498, 1.368546, .593745};
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(robot_test::u(r)[i], u[i], u[i] * 4.0 * std::sqrt(0.5 / 400'000.0));
    const double low[] = {1353.9633, -2.6820, 1422.8359}, high[] = {1356.0273, 2.6806, 1425.1640};
    for (std::size_t i = 0; i < 3; ++i) {
        const MonteCarloOutput& m = *r.outputs[i].monte_carlo;
        const double tolerance = 4.0 * 2.67 * u[i] / std::sqrt(400'000.0) + .003;
        EXPECT_NEAR(1e3 * m.symmetric.low, low[i], tolerance);
        EXPECT_NEAR(1e3 * m.symmetric.high, high[i], tolerance);
    }
}

// Intervals of 8e6 trials; the standard error of an end point is 2.67 u/√M.
TEST(RobotPose, MonteCarloAtTheZeroPose) {
    Robot robot;
    const double M = 1e6;
    const UncertaintyResult r = robot.run("zero-pose", 1'000'000);
    EXPECT_EQ(r.failed_trials, 0u);
    const Row mean{1349.909438, 1.416972, 1431.103761}, u{.527202, 1.368669, .593458};
    const double low[] = {1348.8762, -1.2653, 1429.9402}, high[] = {1350.9429, 4.0977, 1432.2672};
    const double width[] = {2.0666, 5.3628, 2.3269};
    for (std::size_t i = 0; i < 3; ++i) {
        const MonteCarloOutput& m = *r.outputs[i].monte_carlo;
        EXPECT_NEAR(1e3 * m.mean, mean[i], 4.0 * u[i] / std::sqrt(M));
        EXPECT_NEAR(1e3 * m.standard_uncertainty, u[i], u[i] * 4.0 * std::sqrt(0.5 / M));
        const double end_point = 4.0 * 2.67 * u[i] * std::sqrt(1.0 / M + 1.0 / 8e6);
        EXPECT_NEAR(1e3 * m.symmetric.low, low[i], end_point);
        EXPECT_NEAR(1e3 * m.symmetric.high, high[i], end_point);
        EXPECT_NEAR(1e3 * (m.shortest.high - m.shortest.low), width[i], 2.0 * end_point);
        EXPECT_NEAR(m.skewness, 0.0, 4.0 * std::sqrt(6.0 / M) + 1e-4);
        EXPECT_NEAR(m.kurtosis, 0.0, 4.0 * std::sqrt(24.0 / M) + 1e-4);
        ASSERT_TRUE(m_validation(r, i));  // clause 8: largest difference .0048 mm
        EXPECT_LT(1e3 * m_validation(r, i)->d_low, .0048 + end_point);
        EXPECT_LT(1e3 * m_validation(r, i)->d_high, .0048 + end_point);
    }
}

TEST(RobotPose, EllipsoidOfTheZeroPose) {
    Robot robot;
    const UncertaintyResult r = robot.run("zero-pose", 0);
    const Eigen::Matrix3d C = r.covariance.whole().topLeftCorner<3, 3>();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(C);
    const double k2 = 7.814728, axes[] = {1.38076, 1.73713, 3.82612};
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(1e3 * std::sqrt(k2 * solver.eigenvalues()[i]), axes[i], 5e-4);
    EXPECT_GT(std::abs(solver.eigenvectors()(1, 2)), .99) << "the long axis is Y";
    EXPECT_NEAR(1e3 * std::sqrt(C.trace()), 1.582210, 2e-4);
}

TEST(RobotPose, ContributionsByParameter) {
    Robot robot;
    const UncertaintyResult r = robot.run("zero-pose", 0);
    struct {
        std::size_t output;
        const char* symbol;
        double contribution, share;
    } const expected[] = {{0, "d_4", .4637, .77},      {0, "theta_2", .1812, .12}, {0, "a_1", .1664, .10},
                          {0, "theta_3", .0482, .01},  {1, "alpha_4", .7749, .32}, {1, "alpha_5", .7332, .29},
                          {1, "d_3", .7233, .28},      {1, "alpha_3", .3867, .08}, {1, "alpha_1", .1748, .02},
                          {1, "alpha_2", .1674, .015}, {1, "d_5", .0580, .002},    {1, "beta_2", .0252, .0},
                          {2, "theta_3", .3885, .43},  {2, "a_3", .2980, .25},     {2, "theta_2", .2313, .15},
                          {2, "a_5", .1778, .09},      {2, "a_4", .1490, .06},     {2, "a_2", .0637, .01},
                          {2, "theta_5", .0318, .003}};
    for (const auto& e : expected) {
        const BudgetRow* row = robot_test::budget_row(r, e.output, e.symbol);
        ASSERT_NE(row, nullptr) << e.symbol;
        EXPECT_NEAR(1e3 * row->contribution, e.contribution, 6e-5) << e.symbol;
        EXPECT_NEAR(row->share, e.share, .006) << e.symbol;
    }
}

// --- Table 1 from Tables 2 to 4 (Eq 10), all entries

TEST(RobotPose, TableOneFollowsFromItsComponents) {
    Robot robot;
    const auto asset = robot.asset("er10l-components");
    struct {
        std::size_t joint;
        JointParameter parameter;
        double u;
    } const table_1[] = {{2, JointParameter::theta, .0112}, {3, JointParameter::theta, .0188},
                         {4, JointParameter::theta, .0935}, {5, JointParameter::theta, .0146},
                         {3, JointParameter::d, .7233},     {4, JointParameter::d, .4637},
                         {5, JointParameter::d, .0580},     {1, JointParameter::a, .1664},
                         {2, JointParameter::a, .0637},     {3, JointParameter::a, .2980},
                         {4, JointParameter::a, .1490},     {5, JointParameter::a, .1778},
                         {1, JointParameter::alpha, .0108}, {2, JointParameter::alpha, .0081},
                         {3, JointParameter::alpha, .0187}, {4, JointParameter::alpha, .3552},
                         {5, JointParameter::alpha, .3361}, {2, JointParameter::beta, .0099}};
    for (const auto& entry : table_1) {
        const double u =
            standard_uncertainty_of(*offers<SerialRobotSource>(asset), entry.joint - 1, entry.parameter);
        const Unit unit = Unit::of(is_length(entry.parameter) ? "mm" : "deg");
        EXPECT_NEAR(unit.interval_from_si(u), entry.u, .5001e-4) << entry.joint << symbol_of(entry.parameter);
    }
    EXPECT_EQ(asset->evaluation().front().rows, 6u * 4u) << "d_2 is 0 by definition, beta_2 is there";
}

// Degrees of freedom 29, 7 and 5 of the repeats, counts and ranges: k of 95 % is 2.24 to 2.57, not 2.
TEST(RobotPose, EffectiveDegreesOfFreedomOfTableOne) {
    Robot robot;
    SetupTable& table = robot.asset_table("er10l-components", "uncertainties");
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        table.rows[row][7] = row < 5 ? 29.0 : row < 10 ? 7.0 : 5.0;
    const Table parameters = robot.asset("er10l-components")->evaluation().front();
    double least = 1e9, most = 0.0;
    for (const auto& row : test::rows_of(parameters))
        if (const auto* nu = std::get_if<Measured>(&row.back())) {
            least = std::min(least, nu->si);
            most = std::max(most, nu->si);
        }
    EXPECT_NEAR(least, 5.0, .05);
    EXPECT_NEAR(most, 9.6, .05);
}

// --- section 4.1; exact standard deviations

void expect_section_4_1(const char* id, const Row& expected) {
    Robot robot;
    const double M = 1e5;
    const UncertaintyResult r = robot.run(id, 100'000);
    for (std::size_t i = 0; i < 3; ++i) {
        const MonteCarloOutput& m = *r.outputs[i].monte_carlo;
        const double relative = 4.0 * std::sqrt((m.kurtosis + 2.0) / (4.0 * M));
        EXPECT_NEAR(1e3 * m.standard_uncertainty, expected[i], expected[i] * relative + 6e-4) << i;
    }
    EXPECT_NEAR(1e3 * std::sqrt(r.covariance.whole().trace()), expected[3],
                expected[3] * 4.0 * std::sqrt(0.7 / M));
}

TEST(RobotPose, SectionFourOneReadingA) {
    expect_section_4_1("section-4-1-a", {9.309, 13.685, 16.805, 23.587});
}
TEST(RobotPose, SectionFourOneReadingB) {
    expect_section_4_1("section-4-1-b", {9.312, 23.537, 16.804, 30.382});
}
TEST(RobotPose, SectionFourOneReadingC) {
    expect_section_4_1("section-4-1-c", {.9466, 2.3583, 1.6983, 3.0564});
}

// alpha alone at the zero pose has no first-order effect on X and Z: u of the law of propagation is 0, the
// distributions are skewed.
TEST(RobotPose, ZeroSensitivityIsNotZeroUncertainty) {
    Robot robot;
    SetupTable& table = robot.asset_table("er10l-b", "uncertainties");
    table.rows[0] = {std::string("alpha alone"), {}, {}, {}, {}, .01, {}, {}, {}};
    const UncertaintyResult r = robot.run("section-4-1-b", 200'000);
    EXPECT_NEAR(1e3 * r.outputs[0].first_order.standard_uncertainty, 0.0, 1e-9);
    EXPECT_NEAR(1e3 * r.outputs[2].first_order.standard_uncertainty, 0.0, 1e-9);
    EXPECT_NEAR(1e3 * r.outputs[0].monte_carlo->standard_uncertainty, .1703, .004);
    EXPECT_NEAR(1e3 * r.outputs[1].monte_carlo->standard_uncertainty, 19.197, 19.2 * four_errors(2e5));
    EXPECT_NEAR(1e3 * r.outputs[2].monte_carlo->standard_uncertainty, .1806, .004);
    EXPECT_NEAR(r.outputs[0].monte_carlo->skewness, -2.8, .25);
    EXPECT_NEAR(r.outputs[2].monte_carlo->skewness, -1.5, .25);
}

// --- a grid of poses: u_3D 1.5547 to 1.6330, independent of q1

TEST(RobotPose, GridOverTheFirstThreeJoints) {
    Robot robot;
    SetupTable& poses = robot.table("zero-pose", "poses");
    poses.rows.clear();
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
            for (int k = 0; k < 5; ++k)
                poses.rows.push_back({std::to_string(25 * i + 5 * j + k),
                                      -120.0 + 60 * i,
                                      -150.0 + 30 * j,
                                      -60.0 + 30 * k,
                                      0.0,
                                      0.0,
                                      0.0,
                                      {}});
    const UncertaintyResult r = robot.run("zero-pose", 0);
    Row least(4, 1e9), most(4, 0.0), sum(4, 0.0);
    for (std::size_t p = 0; p < 125; ++p) {
        Row u{0, 0, 0, 0};
        for (std::size_t c = 0; c < 3; ++c) {
            u[c] = 1e3 * r.outputs[3 * p + c].first_order.standard_uncertainty;
            u[3] = std::hypot(u[3], u[c]);
        }
        for (std::size_t c = 0; c < 4; ++c) {
            least[c] = std::min(least[c], u[c]);
            most[c] = std::max(most[c], u[c]);
            sum[c] += u[c] / 125.0;
        }
        const double first_q1 = r.outputs[3 * (p % 25) + 2].first_order.standard_uncertainty;
        EXPECT_NEAR(u[2], 1e3 * first_q1, 1e-9) << "u_Z depends on q1";
    }
    expect_near(least, {.5009, .8024, .4725, 1.5547}, 1.2e-4);
    expect_near(most, {1.2658, 1.4071, .6540, 1.6330}, 1.2e-4);
    expect_near(sum, {1.0932, .9522, .5451, 1.5863}, 1.2e-4);
}

// --- the adaptive procedure

TEST(RobotPose, AdaptiveStopsWhereNormalTheorySays) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        Robot robot;
        AnalysisEntry& analysis = robot.find("zero-pose-adaptive");
        analysis.options.seed = seed;
        const auto prepared = robot.prepare("zero-pose-adaptive");
        const UncertaintyResult r = run_analysis(*prepared).value();
        EXPECT_TRUE(r.stabilised);
        const double batches = static_cast<double>(r.trials) / 10'000.0;
        EXPECT_GE(batches, 150.0) << "20 runs: 197 to 260, median 225";
        EXPECT_LE(batches, 310.0);
    }
}

TEST(RobotPose, TheToleranceOfThePaperIsForetoldAsOutOfReach) {
    Robot robot;
    robot.find("zero-pose-adaptive").options.tolerance = Quantity{.0001, Unit::of("mm")};
    ASSERT_NE(robot.prepare("zero-pose-adaptive"), nullptr);
    EXPECT_NE(robot.words().find("a tolerance of 0.0001 mm for y"), std::string::npos) << robot.words();
    EXPECT_NE(robot.words().find("5300000000 trials"), std::string::npos) << robot.words();
}

/// Two joints in a plane: z is known exactly.
void make_planar(Robot& robot, double u_theta) {
    covaria::SetupTable& joints = robot.asset_table("er10l-nominal", "joints");
    joints.rows.resize(2);
    joints.rows[0] = {0.0, 0.0, 300.0, 0.0, 0.0, {}, {}, {}, {}, {}, {}};
    joints.rows[1] = {30.0, 0.0, 200.0, 0.0, {}, {}, {}, {}, {}, {}, {}};
    covaria::SetupTable& u = robot.asset_table("er10l-nominal", "uncertainties");
    u.rows = {{std::string("typed"), 1.0, u_theta, {}, {}, {}, {}, {}, {}}};
    covaria::SetupTable& poses = robot.table("zero-pose-nominal", "poses");
    poses.rows[0] = {std::string("zero"), 0.0, 0.0, {}, {}, {}, {}, {}};
}

TEST(RobotPose, APlanarArmIsExactAcrossItsPlane) {
    Robot robot;
    make_planar(robot, .01);
    const UncertaintyResult r = robot.run("zero-pose-nominal", 20'000);
    EXPECT_EQ(r.failed_trials, 0u);
    EXPECT_GT(r.outputs[1].monte_carlo->standard_uncertainty, 1e-5);
    const MonteCarloOutput& z = *r.outputs[2].monte_carlo;
    EXPECT_EQ(z.standard_uncertainty, 0.0);
    EXPECT_EQ(z.shortest.high - z.shortest.low, 0.0);
    EXPECT_TRUE(std::isfinite(z.skewness) && std::isfinite(z.kurtosis));
}

// An output without uncertainty has no digits to agree on, and needs none.
TEST(RobotPose, AdaptiveRunsEndForExactOutputsAndGenerousTolerances) {
    Robot robot;
    make_planar(robot, .01);
    EvaluationOptions& options = robot.find("zero-pose-nominal").options;
    options.method = Method::adaptive;
    options.maximum_trials = 5'000'000;
    UncertaintyResult r = run_analysis(*robot.prepare("zero-pose-nominal")).value();
    EXPECT_TRUE(r.stabilised);
    options.tolerance = Quantity{5.0, Unit::of("mm")};  // far above u
    r = run_analysis(*robot.prepare("zero-pose-nominal")).value();
    EXPECT_TRUE(r.stabilised);
    EXPECT_EQ(r.trials, 10u * 10'000u) << "the least number of batches";
}

TEST(RobotPose, NoUncertaintyAtAll) {
    Robot robot;
    make_planar(robot, 0.0);
    const UncertaintyResult r = robot.run("zero-pose-nominal", 10'000);
    for (const OutputResult& y : r.outputs) {
        EXPECT_EQ(y.monte_carlo->standard_uncertainty, 0.0);
        EXPECT_EQ(y.first_order.standard_uncertainty, 0.0);
    }
}

TEST(RobotPose, BetaAndDOfOneJointAreRefused) {
    Robot robot;
    robot.asset_table("er10l-nominal", "joints").rows[1][1] = 5.0;
    EXPECT_EQ(robot.prepare("zero-pose-nominal"), nullptr);
    EXPECT_NE(robot.words().find("where beta is given, d is 0 by definition"), std::string::npos)
        << robot.words();
}

}  // namespace
}  // namespace covaria::robot_pose_test
