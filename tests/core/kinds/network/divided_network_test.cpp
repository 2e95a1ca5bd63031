// Networks with too many readings to be weighed together: each target by itself, its weights by sensor, its
// sensitivity coefficients by the condition that holds at the estimate.
#include <gtest/gtest.h>

#include <random>

#include "tests/bench/large_network.h"
#include "tests/core/made.h"

namespace covaria::divided_network_test {
namespace {

constexpr int sensors = 8, targets = 30;  // 720 readings

/// Readings of the design with deviations of some standard uncertainties.
void give_readings(const PreparedAnalysis& design, AnalysisEntry& entry, double width) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> noise(0.0, width);
    SetupTable readings;
    readings.units = {Unit(), Unit(), Unit::of("mm"), Unit::of("rad"), Unit::of("rad")};
    for (int t = 0; t < targets; ++t)
        for (int s = 0; s < sensors; ++s) {
            const std::string target = "P" + std::to_string(t), sensor = "T" + std::to_string(s);
            const auto cell = [&](const std::string& letter, double factor) -> SetupCell {
                const std::size_t i = design.inputs.find(letter + "_" + target + "_" + sensor);
                return factor * (estimate_of(design.inputs, i) +
                                 noise(engine) * standard_uncertainty_of(design.inputs, i));
            };
            readings.rows.push_back({target, sensor, cell("d", 1e3), cell("theta", 1.0), cell("phi", 1.0)});
        }
    entry.setup.values["evaluation"] = std::string("a-posteriori");
    entry.setup.values["readings"] = std::move(readings);
}

std::shared_ptr<const PreparedAnalysis> prepared(const Project& project) {
    Problems problems;
    auto analysis = made_analysis(project, project.analyses.front().id, problems);
    for (const Problem& p : problems.items())
        if (p.severity == Severity::error) ADD_FAILURE() << p.path << ": " << p.message.english();
    return analysis;
}

void expect_rows_of_the_jacobian(const PreparedAnalysis& analysis) {
    std::vector<double> x;
    for (std::size_t i = 0; i < analysis.inputs.quantities.size(); ++i)
        x.push_back(estimate_of(analysis.inputs, i));
    Eigen::MatrixXd exact;  // found by the iteration in dual numbers
    SensitivityRows rows;
    ASSERT_TRUE(analysis.model->jacobian(x, exact));
    ASSERT_TRUE(analysis.model->sensitivities(x, rows));
    ASSERT_EQ(rows.size(), 3u * targets);
    for (std::size_t j = 0; j < rows.size(); ++j) {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(exact.cols());
        for (std::size_t k = 0; k < rows[j].size(); ++k) {
            row[static_cast<Eigen::Index>(rows[j][k].input)] += rows[j][k].coefficient;
            if (k > 0) {
                EXPECT_LT(rows[j][k - 1].input, rows[j][k].input);
            }
        }
        const auto of_matrix = exact.row(static_cast<Eigen::Index>(j));
        EXPECT_GT(of_matrix.cwiseAbs().maxCoeff(), 0.0);
        EXPECT_LE((row - of_matrix).cwiseAbs().maxCoeff(), 1e-9 * of_matrix.cwiseAbs().maxCoeff()) << j;
    }
}

TEST(DividedNetwork, SensitivitiesAreTheJacobianOfTheEstimate) {
    Project project = bench::large_network(sensors, targets);
    const auto design = prepared(project);
    ASSERT_TRUE(design);
    expect_rows_of_the_jacobian(*design);
    give_readings(*design, project.analyses.front(), 5.0);
    const auto measured = prepared(project);
    ASSERT_TRUE(measured);
    expect_rows_of_the_jacobian(*measured);
}

// The set-up of one of its targets is small enough for the weights of all: the same numbers by another way.
TEST(DividedNetwork, ATargetIsWhatItIsAlone) {
    Project project = bench::large_network(sensors, targets);
    const auto all = prepared(project);
    auto& rows = std::get<SetupTable>(project.analyses.front().setup.values.at("targets")).rows;
    rows = {rows[17]};
    const auto one = prepared(project);
    ASSERT_TRUE(all && one);
    const auto& law = *all->propagated->propagation();
    const auto& alone = *one->propagated->propagation();
    for (Eigen::Index c = 0; c < 3; ++c) {
        EXPECT_NEAR(law.law.estimate(3 * 17 + c), alone.law.estimate(c), 1e-12);
        EXPECT_NEAR(law.law.uncertainty(3 * 17 + c), alone.law.uncertainty(c),
                    1e-9 * alone.law.uncertainty(c));
    }
}

// The inputs that a target depends on do not grow with the number of the other targets.
TEST(DividedNetwork, SensitivitiesGrowWithTheTargetsAlone) {
    const auto coefficients = [](int count) {
        const auto analysis = prepared(bench::large_network(sensors, count));
        std::vector<double> x;
        for (std::size_t i = 0; i < analysis->inputs.quantities.size(); ++i)
            x.push_back(estimate_of(analysis->inputs, i));
        SensitivityRows rows;
        EXPECT_TRUE(analysis->model->sensitivities(x, rows));
        std::size_t sum = 0;
        for (const auto& row : rows) sum += row.size();
        return sum;
    };
    const std::size_t once = coefficients(40), thrice = coefficients(120);
    EXPECT_LE(thrice, 3 * once + 3 * once / 10);
}

}  // namespace
}  // namespace covaria::divided_network_test
