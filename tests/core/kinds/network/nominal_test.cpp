// Results of networks of given readings depend on the readings and on the statements about stations, never
// on where targets and stations were said to be beforehand.
#include <gtest/gtest.h>

#include "tests/core/kinds/network/random_network.h"

namespace covaria::network_nominal_test {
namespace {

using namespace random_network;

void expect_same(const Found& found, const Found& right, double shares_of_u, double relative_u,
                 const std::string& what) {
    ASSERT_EQ(found.y.size(), right.y.size()) << what;
    for (std::size_t i = 0; i < right.y.size(); ++i) {
        EXPECT_NEAR(found.y[i], right.y[i], shares_of_u * right.u[i]) << what << ' ' << i;
        EXPECT_NEAR(found.u[i], right.u[i], relative_u * right.u[i]) << what << ' ' << i;
    }
}

TEST(NetworkNominals, ResultsDoNotDependOnTheTypedTargets) {
    std::mt19937_64 engine(42);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int k = 0; k < 12; ++k) {
        World w = world(engine, 2 + static_cast<std::size_t>(k % 4), 2 + static_cast<std::size_t>(k % 5),
                        k % 3 == 0 ? 0.0 : 0.2, k % 2 == 0 ? 0.0 : 10.0);
        for (const char* weights : {"with-stations", "observations"}) {
            w.nominal = w.targets;
            const Found right = found_by(project_of(w, weights));
            for (const double mm : {10.0, 300.0, 2000.0}) {
                for (std::size_t t = 0; t < w.targets.size(); ++t)
                    w.nominal[t] =
                        w.targets[t] + mm * Eigen::Vector3d(unit(engine), unit(engine), unit(engine));
                expect_same(found_by(project_of(w, weights)), right, 1e-6, 1e-7,
                            std::to_string(k) + weights + std::to_string(mm));
            }
        }
    }
}

TEST(NetworkNominals, ANominalFarFromWhereTheReadingsFindATargetIsSaid) {
    std::mt19937_64 engine(1);
    World w = world(engine, 3, 4, 0.1, 5.0);
    EXPECT_EQ(found_by(project_of(w)).words, "");
    w.nominal[2].x() += 500.0;
    const std::string words = found_by(project_of(w)).words;
    EXPECT_NE(words.find("target P2 "), std::string::npos) << words;
    EXPECT_EQ(words.find("target P1 "), std::string::npos) << words;
}

// Stated positions are only the beginning of a search: next to nothing is known of the stations, of all
// but one.
TEST(NetworkNominals, ResultsDoNotDependOnStationsThatAreFree) {
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int k = 0; k < 6; ++k) {
        World w = world(engine, 3 + static_cast<std::size_t>(k % 3), 7 + static_cast<std::size_t>(k), 1e4,
                        60'000.0);
        const Found right = found_by(project_of(w));
        for (const double mm : {1.0, 100.0, 400.0}) {
            for (std::size_t s = 1; s < w.stated.size(); ++s)
                w.stated[s] = w.instruments[s].position +
                              mm * Eigen::Vector3d(unit(engine), unit(engine), unit(engine));
            expect_same(found_by(project_of(w)), right, 1e-3, 1e-6,
                        std::to_string(k) + " " + std::to_string(mm));
        }
    }
}

// The more a station is left open the less it has to say: in the limit nothing, whatever the figure is.
TEST(NetworkNominals, AStationLeftOpenByMoreChangesNothing) {
    std::mt19937_64 engine(5);
    for (int k = 0; k < 4; ++k) {
        World w = world(engine, 3, 8, 1e3, 2e4);
        const Found metre = found_by(project_of(w));
        for (const double times : {10.0, 1e3}) {
            World open = w;
            for (std::size_t s = 1; s < w.instruments.size(); ++s) {
                open.instruments[s].u_position *= times;
                open.instruments[s].u_angle *= std::min(times, 10.0);
            }
            expect_same(found_by(project_of(open)), metre, 1e-3, 1e-5, std::to_string(times));
        }
    }
}

// Each trial finds such stations anew: what they were drawn to be is metres away.
TEST(NetworkNominals, MonteCarloFindsStationsThatAreFree) {
    std::mt19937_64 engine(9);
    World w = world(engine, 3, 6, 1e3, 2e4);
    for (std::size_t s = 1; s < w.stated.size(); ++s) w.stated[s].x() += 50.0;
    Project project = project_of(w);
    constexpr std::uint64_t trials = 4000;
    project.analyses.front().options.method = Method::monte_carlo;
    project.analyses.front().options.trials = trials;
    Problems problems;
    const auto prepared = made_analysis(project, project.analyses.front().id, problems);
    ASSERT_TRUE(prepared);
    const auto result = run_analysis(*prepared, {});
    EXPECT_EQ(result->failed_trials, 0u);
    for (const OutputResult& y : result->outputs) {
        ASSERT_TRUE(y.monte_carlo);
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty / y.first_order.standard_uncertainty, 1.0,
                    4.0 * std::sqrt(0.5 / trials))
            << y.quantity.name.english();
        EXPECT_NEAR(y.monte_carlo->mean, y.first_order.estimate,
                    4.0 * y.first_order.standard_uncertainty / std::sqrt(double(trials)));
    }
}

// The derivative of an estimate is that of what it minimises, however stations and residuals bend it.
TEST(NetworkNominals, SensitivitiesAreTheJacobianWhereStationsAreFound) {
    std::mt19937_64 engine(3);
    for (const double u_position : {0.2, 1e3}) {
        const World w = world(engine, 3, 5, u_position, 20.0 * u_position);
        Problems problems;
        const Project project = project_of(w);
        const auto analysis = made_analysis(project, project.analyses.front().id, problems);
        ASSERT_TRUE(analysis);
        std::vector<double> x;
        for (std::size_t i = 0; i < analysis->inputs.quantities.size(); ++i)
            x.push_back(estimate_of(analysis->inputs, i));
        Eigen::MatrixXd exact;  // found by the iteration in dual numbers
        SensitivityRows rows;
        ASSERT_TRUE(analysis->model->jacobian(x, exact));
        ASSERT_TRUE(analysis->model->sensitivities(x, rows));
        for (std::size_t j = 0; j < rows.size(); ++j) {
            Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(exact.cols());
            for (const Sensitivity& s : rows[j]) row[static_cast<Eigen::Index>(s.input)] += s.coefficient;
            const auto of_matrix = exact.row(static_cast<Eigen::Index>(j));
            EXPECT_LE((row - of_matrix).cwiseAbs().maxCoeff(), 1e-8 * of_matrix.cwiseAbs().maxCoeff())
                << u_position << ' ' << j;
        }
    }
}

}  // namespace
}  // namespace covaria::network_nominal_test
