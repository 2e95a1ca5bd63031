// Accuracy and repeatability of poses (ISO 9283): laws of few cycles against closed forms and simulated
// campaigns, figures against numbers computed here.
#include <cmath>
#include <numbers>
#include <random>

#include "core/kinds/sheets/repeatability_law.h"
#include "core/text/cell.h"
#include "tests/core/kinds/sheets/made_sheet.h"

namespace covaria::sheets_test {
namespace {

using sheets::mean_length;
using sheets::repeatability;
using sheets::repeatability_law;
using sheets::repeatability_of_scatter;
using sheets::RepeatabilityLaw;

constexpr const char* performance = "robot-pose-performance";

class Cell {
public:
    explicit Cell(unsigned seed) : generator_(seed) {}
    Eigen::MatrixX3d cycles(int n, const Eigen::Vector3d& place, const Eigen::Vector3d& s) {
        Eigen::MatrixX3d points(n, 3);
        for (int i = 0; i < n; ++i)
            for (int axis = 0; axis < 3; ++axis)
                points(i, axis) = place[axis] + s[axis] * normal_(generator_);
        return points;
    }

private:
    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
};

struct Series {
    std::string pose, direction;
    std::optional<double> hours;
    Eigen::MatrixX3d points;  ///< mm
};

/// Coordinates in mm; commanded poses without angles.
covaria::Setup setup_of(const std::vector<std::pair<std::string, Eigen::Vector3d>>& commanded,
                        const std::vector<Series>& attained) {
    const Unit mm = Unit::of("mm"), deg = Unit::of("deg");
    SetupTable poses, cycles;
    poses.units = {Unit{}, mm, mm, mm, deg, deg, deg};
    for (const auto& [name, p] : commanded)
        poses.rows.push_back({name, p[0], p[1], p[2], std::monostate{}, std::monostate{}, std::monostate{}});
    cycles.units = {Unit{}, Unit{}, Unit::of("h"), mm, mm, mm, deg, deg, deg};
    for (const Series& s : attained)
        for (const auto& p : s.points.rowwise())
            cycles.rows.push_back({s.pose, s.direction.empty() ? SetupCell() : SetupCell(s.direction),
                                   s.hours ? SetupCell(*s.hours) : SetupCell(), p[0], p[1], p[2],
                                   std::monostate{}, std::monostate{}, std::monostate{}});
    covaria::Setup setup;
    setup.values["commanded"] = poses;
    setup.values["attained"] = cycles;
    return setup;
}

TEST(RepeatabilityLaw, MeanLengthsAreTheClosedOnes) {
    EXPECT_NEAR(mean_length({1.0, 1.0, 1.0}), std::sqrt(8.0 / std::numbers::pi), 1e-6);
    EXPECT_NEAR(mean_length({0.0, 2.0, 2.0}), 2.0 * std::sqrt(std::numbers::pi / 2.0), 2e-6);
    EXPECT_NEAR(mean_length({0.0, 0.0, 3.0}), 3.0 * std::sqrt(2.0 / std::numbers::pi), 3e-6);
    EXPECT_NEAR(repeatability_of_scatter({1.0, 1.0, 1.0}), 3.6161, 5e-5);
}

TEST(RepeatabilityLaw, FewCyclesMakeItSmallAndUncertain) {
    const Eigen::Vector3d isotropic = Eigen::Vector3d::Ones();
    const RepeatabilityLaw thirty = repeatability_law(isotropic, 30, 40000),
                           ten = repeatability_law(isotropic, 10, 40000);
    EXPECT_NEAR(thirty.bias * thirty.of_infinite, 3.538, 0.006);
    EXPECT_NEAR(ten.bias * ten.of_infinite, 3.363, 0.010);
    EXPECT_NEAR(thirty.relative_u, 0.093, 0.0015);
    EXPECT_NEAR(ten.relative_u, 0.167, 0.0025);
    EXPECT_NEAR(thirty.of_infinite / thirty.quantiles[98], 2.92, 0.06) << "about the 2.5 % quantile of RP";
}

// The interval of RP and that of AP of 500 campaigns hold the true figure as often as they say.
TEST(RepeatabilityLaw, CoversForEveryShapeOfScatter) {
    const std::pair<const char*, Eigen::Vector3d> shapes[] = {
        {"isotropic", {1.0, 1.0, 1.0}}, {"flat", {1.0, 1.0, 0.05}}, {"long", {1.0, 0.15, 0.1}}};
    for (const auto& [name, s] : shapes) {
        Cell cell(47);
        int covered = 0, campaigns = 500;
        const double truth = repeatability_of_scatter(s);
        for (int k = 0; k < campaigns; ++k) {
            const Eigen::MatrixX3d points = cell.cycles(30, {10.0, -4.0, 2.0}, s);
            const RepeatabilityLaw law = repeatability_law(sheets::principal_deviations(points), 30, 1000);
            const double p = law.probability_below(truth / repeatability(points));
            covered += p > 0.025 && p < 0.975 ? 1 : 0;
        }
        EXPECT_GE(covered, 0.93 * campaigns) << name;
        // Thirty cycles of a ball look longer than the ball, and what is longer is less certain: 97.3 % of
        // 2000.
        EXPECT_LE(covered, (s == Eigen::Vector3d::Ones() ? 0.985 : 0.97) * campaigns) << name;
    }
}

TEST(RobotPoses, AccuracyCoversForEveryShapeOfScatter) {
    for (const Eigen::Vector3d& s : {Eigen::Vector3d(0.01, 0.01, 0.01), Eigen::Vector3d(0.01, 0.01, 5e-4),
                                     Eigen::Vector3d(0.01, 1e-3, 2e-3)}) {
        Cell cell(3);
        int covered = 0;
        const Eigen::Vector3d deviation(0.04, -0.02, 0.03);
        for (int k = 0; k < 500; ++k) {
            const Eigen::MatrixX3d points = cell.cycles(30, deviation, s);
            const Eigen::Vector3d mean = points.colwise().mean();
            const Eigen::Matrix3d covariance = sheets::covariance_of(points) / 30.0;
            const Eigen::Vector3d direction = mean.normalized();
            const double u = std::sqrt(direction.dot(covariance * direction));
            covered += std::abs(mean.norm() - deviation.norm()) <= 2.0452 * u ? 1 : 0;  // t_.975(29)
        }
        EXPECT_GE(covered, 465);
        EXPECT_LE(covered, 485);
    }
    // ... and the model's u(AP) is that u.
    Cell cell(9);
    const Eigen::MatrixX3d points = cell.cycles(30, {1.04, -0.02, 0.03}, {0.01, 0.004, 0.007});
    const auto model = made(performance, setup_of({{"P1", {1.0, 0.0, 0.0}}}, {{"P1", "", {}, points}}));
    const Eigen::Vector3d mean = points.colwise().mean().transpose() - Eigen::Vector3d(1.0, 0.0, 0.0);
    const double u =
        std::sqrt(mean.normalized().dot(sheets::covariance_of(points) / 30.0 * mean.normalized()));
    const FirstOrderOutput ap = first_order(*model, "AP");
    EXPECT_NEAR(1e3 * ap.estimate, mean.norm(), 1e-12);
    EXPECT_NEAR(1e3 * ap.standard_uncertainty, u, 1e-12);
    EXPECT_NEAR(ap.effective_degrees_of_freedom, 29.0, 1e-6);
}

TEST(RobotPoses, RepeatabilityIsThatOfTheStandardTimesWhatFewCyclesMakeOfIt) {
    Cell cell(5);
    const Eigen::MatrixX3d points = cell.cycles(30, {1.0, 2.0, 3.0}, {0.02, 0.01, 0.005});
    double mean = 0.0, squares = 0.0;
    const Eigen::RowVector3d barycentre = points.colwise().mean();
    for (const auto& p : points.rowwise()) mean += (p - barycentre).norm() / 30.0;
    for (const auto& p : points.rowwise()) squares += std::pow((p - barycentre).norm() - mean, 2);
    const double rp = mean + 3.0 * std::sqrt(squares / 29.0);
    const auto model = made(performance, setup_of({{"P1", {1.0, 2.0, 3.0}}}, {{"P1", "", {}, points}}));
    EXPECT_NEAR(1e3 * value(table_of(model->evaluation(), "sheet").columns[4].cell(0)), rp, 1e-12);
    const FirstOrderOutput result = first_order(*model, "RP");
    const double factor = 1e3 * result.estimate / rp;
    EXPECT_GT(factor, 1.01);
    EXPECT_LT(factor, 1.05);
    EXPECT_GT(result.standard_uncertainty / result.estimate, 0.09) << "a disk is less certain than a ball";
    EXPECT_LT(result.standard_uncertainty / result.estimate, 0.15);
}

// A robot of 6 um and a tracker of 5 um along each axis: the tracker has 25/61 of the variance.
TEST(RobotPoses, TheShareOfASimulatedTrackerIsFoundWithItsUncertainty) {
    const double share = 25.0 / 61.0, robot = 6.0 * 3.6161;
    int covered = 0;
    double sum = 0.0, scatter = 0.0, stated = 0.0;
    constexpr int campaigns = 150;
    Cell cell(12);
    for (int k = 0; k < campaigns; ++k) {
        covaria::Setup setup =
            setup_of({{"P1", {0.0, 0.0, 0.0}}},
                     {{"P1",
                       "",
                       {},
                       cell.cycles(30, {0.1, 0.0, 0.0}, Eigen::Vector3d::Constant(1e-3 * std::sqrt(61.0)))}});
        setup.values["instrument"] = std::string("readings");
        SetupTable target;
        target.units.assign(3, Unit::of("mm"));
        const auto fixed = cell.cycles(30, {0.0, 0.0, 0.0}, Eigen::Vector3d::Constant(5e-3));
        for (Eigen::Index i = 0; i < fixed.rows(); ++i)
            target.rows.push_back({fixed(i, 0), fixed(i, 1), fixed(i, 2)});
        setup.values["fixed_target"] = target;
        const auto model = made(performance, setup);
        const FirstOrderOutput w = first_order(*model, "w_I"), r = first_order(*model, "RP_R");
        covered += std::abs(w.estimate - share) <= 2.0 * w.standard_uncertainty ? 1 : 0;
        sum += 1e6 * r.estimate / campaigns;
        scatter += (w.estimate - share) * (w.estimate - share) / campaigns;
        stated += w.standard_uncertainty * w.standard_uncertainty / campaigns;
    }
    EXPECT_GE(covered, 0.90 * campaigns);
    EXPECT_LT(covered, campaigns);
    EXPECT_NEAR(sum / robot, 1.0, 0.03);
    EXPECT_NEAR(std::sqrt(stated / scatter), 1.0, 4.0 / std::sqrt(2.0 * campaigns));
}

TEST(RobotPoses, DirectionsDriftAndDistances) {
    Cell cell(8);
    const Eigen::Vector3d s = Eigen::Vector3d::Constant(0.01);
    const auto series = [&](const char* pose, const char* direction, std::optional<double> hours,
                            const Eigen::Vector3d& place) {
        return Series{pose, direction, hours, cell.cycles(12, place, s)};
    };
    const std::vector<Series> all{
        series("A", "above", {}, {0.1, 0.0, 0.0}), series("A", "left", {}, {0.1, 0.4, 0.0}),
        series("A", "right", {}, {0.1, 0.2, 0.3}), series("B", "", 0.0, {100.2, 0.0, 0.0}),
        series("B", "", 4.0, {100.5, 0.0, 0.0}),   series("B", "", 1.0, {100.9, 0.0, 0.0})};
    covaria::Setup setup = setup_of({{"A", {0.0, 0.0, 0.0}}, {"B", {100.0, 0.0, 0.0}}}, all);
    SetupTable pairs;
    pairs.units.assign(2, Unit{});
    pairs.rows.push_back({std::string("A"), std::string("B")});
    setup.values["distances"] = pairs;
    const auto model = made(performance, setup);
    const auto mean = [&](std::size_t k) -> Eigen::Vector3d {
        return all[k].points.colwise().mean().transpose();
    };
    const double vap =
        std::max({(mean(0) - mean(1)).norm(), (mean(0) - mean(2)).norm(), (mean(1) - mean(2)).norm()});
    EXPECT_NEAR(1e3 * first_order(*model, "vAP").estimate, vap, 1e-10);
    const Eigen::Vector3d b(100.0, 0.0, 0.0);
    const double start = (mean(3) - b).norm();
    EXPECT_NEAR(1e3 * first_order(*model, "dAP").estimate,
                std::max(std::abs((mean(4) - b).norm() - start), std::abs((mean(5) - b).norm() - start)),
                1e-10);
    const Eigen::VectorXd lengths = (all[3].points - all[0].points).rowwise().norm();
    const double s_lengths = std::sqrt((lengths.array() - lengths.mean()).square().sum() / 11.0);
    const FirstOrderOutput ad = first_order(*model, "AD"), rd = first_order(*model, "RD");
    EXPECT_NEAR(1e3 * ad.estimate, std::abs(lengths.mean() - 100.0), 1e-9);
    EXPECT_NEAR(1e3 * ad.standard_uncertainty, s_lengths / std::sqrt(12.0), 1e-9);
    // sqrt(nu/chi^2) has the mean sqrt(nu/2) Gamma((nu - 1)/2)/Gamma(nu/2).
    EXPECT_NEAR(1e3 * rd.estimate / (3.0 * s_lengths), std::sqrt(5.5) * std::tgamma(5.0) / std::tgamma(5.5),
                0.005);
}

TEST(RobotPoses, DecidesAboutTheMakersFigures) {
    Cell cell(21);
    const Eigen::MatrixX3d points = cell.cycles(30, {0.1, 0.0, 0.0}, Eigen::Vector3d::Constant(0.01));
    const auto decided = [&](double rated_rp) {
        covaria::Setup setup = setup_of({{"P1", {0.0, 0.0, 0.0}}}, {{"P1", "", {}, points}});
        setup.values["rated_rp"] = Quantity{rated_rp, Unit::of("mm")};
        const auto model = made(performance, setup);
        return test::rows_of(table_of(model->evaluation(), "conformity")).at(0);
    };
    const double rp = repeatability(points);
    EXPECT_EQ(english_of(decided(1.4 * rp)[5]), "conforms");
    EXPECT_EQ(english_of(decided(0.7 * rp)[5]), "does not conform");
    const auto open = decided(1.1 * rp);
    EXPECT_EQ(english_of(open[5]), "not decided");
    const double cycles = value(open[7]), room = 1.1 * rp - 1e3 * value(open[1]);
    EXPECT_GT(cycles, 30.0);
    EXPECT_NEAR(std::sqrt((cycles - 1.0) / 29.0), 1.6449 * 1e3 * value(open[2]) / room, 0.05);
}

// RP² of the robot is that of both less that of the instrument; a thousand readings leave RP_I without doubt.
TEST(RobotPoses, DecidesAboutTheRobotWithoutTheInstrument) {
    Cell cell(21);
    const Eigen::MatrixX3d points = cell.cycles(30, {0.1, 0.0, 0.0}, Eigen::Vector3d::Constant(0.01));
    covaria::Setup setup = setup_of({{"P1", {0.0, 0.0, 0.0}}}, {{"P1", "", {}, points}});
    const auto decided = [&](double rated_rp, double of_instrument) {
        setup.values["rated_rp"] = Quantity{rated_rp, Unit::of("mm")};
        setup.values["instrument"] = std::string("stated");
        setup.values["instrument_rp"] = Quantity{of_instrument, Unit::of("mm")};
        setup.values["instrument_cycles"] = Quantity{1000.0, Unit{}};
        return made(performance, setup);
    };
    const auto row = [](const auto& model) {
        return test::rows_of(table_of(model->evaluation(), "conformity")).at(0);
    };
    const double rp = repeatability(points);
    const auto model = decided(rp, 0.8 * rp);
    const auto conforming = row(model);
    EXPECT_EQ(english_of(conforming[5]), "conforms") << "0.6 of RP are the robot's";
    const FirstOrderOutput own = first_order(*model, "RP_R");
    EXPECT_NEAR(value(conforming[1]) / own.estimate, 1.0, 1e-9);
    EXPECT_NEAR(value(conforming[2]) / own.standard_uncertainty, 1.0, 1e-9);
    EXPECT_EQ(english_of(row(decided(0.2 * rp, 0.8 * rp))[5]), "does not conform");

    const auto nothing_left = decided(rp, 1.6 * rp);
    EXPECT_EQ(english_of(row(nothing_left)[5]), "not decided");
    for (const OutputQuantity& output : nothing_left->outputs()) {
        EXPECT_NE(output.symbol, "RP_R");
        EXPECT_NE(output.symbol, "w_I");
    }
    EXPECT_EQ(nothing_left->outputs().size(), 2u) << "AP and RP";
    EXPECT_GT(first_order(*nothing_left, "RP").estimate, 0.0);
}

TEST(RobotPoses, TheInstrumentIsHeldAgainstTheRatioThatIsEntered) {
    Cell cell(2);
    covaria::Setup setup =
        setup_of({{"P1", {0.0, 0.0, 0.0}}},
                 {{"P1", "", {}, cell.cycles(30, {0.1, 0.0, 0.0}, Eigen::Vector3d::Constant(0.01))}});
    setup.values["expanded_u"] = Quantity{0.015, Unit::of("mm")};
    Problems problems;
    EXPECT_FALSE(made(performance, setup, problems)) << "no ratio is built in";
    setup.values["largest_ratio"] = Quantity{25.0, Unit::of("%")};
    const auto model = made(performance, setup);
    const Table rule = table_of(model->evaluation(), "instrument-rule");
    EXPECT_EQ(english_of(rule.columns[4].cell(0)), "passed") << "15 um of 100 um";
    EXPECT_EQ(english_of(rule.columns[4].cell(1)), "not passed") << "15 um of 36 um";
}

}  // namespace
}  // namespace covaria::sheets_test
