// Points from measured lengths of more than three ballbars: place, residuals, and what these see.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/base/resource_path.h"
#include "core/evidence/seen.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace covaria::lengths_test {
namespace {

/// Twenty points above five supports; lengths in mm.
struct FiveBars {
    const std::vector<Eigen::Vector3d> supports{
        {0, 0, 0}, {520, 0, 0}, {260, 450, 0}, {700, 100, 0}, {300, -300, 0}};
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::VectorXd> lengths;
    Project project = load_project(data_directory() / "projects/ballbar-tcp.covaria").project;
    Problems problems;

    /// `noise`: standard deviation of a reading, mm; stated are 2 µm.
    explicit FiveBars(double noise) {
        std::mt19937_64 random(3);
        std::normal_distribution<double> normal(0.0, noise);
        for (int k = 0; k < 20; ++k) {
            points.emplace_back(100.0 * (k % 5), 150.0 * (k / 5) - 100.0, 400.0 + 20.0 * k);
            Eigen::VectorXd read(5);
            for (int j = 0; j < 5; ++j)
                read[j] = (points.back() - supports[std::size_t(j)]).norm() + normal(random);
            lengths.push_back(read);
        }
    }

    static Quantity um(double value) { return {value, Unit::of("um")}; }

    std::shared_ptr<const PreparedAnalysis> prepare(const std::string& uncertainties = "stated") {
        SetupTable further, rows;
        further.units.assign(5, Unit::of("mm"));
        for (std::size_t k = 3; k < supports.size(); ++k) {
            const auto to = [&](std::size_t j) { return (supports[k] - supports[j]).norm(); };
            further.rows.push_back({to(0), to(1), to(2), 0.0, 0.0});
        }
        for (AssetEntry& asset : project.assets) {
            if (asset.id != "ballbars") continue;
            asset.setup.values["further_supports"] = further;
            asset.setup.values["reading_constant"] = um(2.0);
            asset.setup.values["support_constant"] = um(0.0);
            asset.setup.values["meaning"] = std::string("standard");
        }
        rows.units = {Unit{}, Unit{}, Unit::of("mm")};
        for (std::size_t k = 0; k < points.size(); ++k)
            for (Eigen::Index j = 0; j < lengths[k].size(); ++j)
                rows.rows.push_back({"P" + std::to_string(k + 1), double(j + 1), lengths[k][j]});
        for (AnalysisEntry& analysis : project.analyses) {
            if (analysis.id != "paper") continue;
            analysis.setup.values = {{"ballbars", std::string("ballbars")},
                                     {"evaluation", std::string("lengths")},
                                     {"lengths", rows},
                                     {"uncertainties", uncertainties}};
            analysis.options.method = Method::first_order;
        }
        problems = {};
        return made_analysis(project, "paper", problems);
    }
    UncertaintyResult run(const std::string& uncertainties) {
        const auto prepared = prepare(uncertainties);
        if (!prepared) throw std::runtime_error(problems.items().front().message.english());
        return run_analysis(*prepared).value();
    }
    bool warns() const {
        for (const Problem& problem : problems.items())
            if (problem.message.english().find("the lengths contradict each other") == 0) return true;
        return false;
    }

    /// Gauss-Newton of point k with equal weights, mm, and the sum of squares that is left.
    std::pair<Eigen::Vector3d, double> by_hand(std::size_t k) const {
        Eigen::Vector3d p = points[k];
        Eigen::VectorXd left(5);
        for (int step = 0; step < 10; ++step) {
            Eigen::MatrixXd J(5, 3);
            for (int j = 0; j < 5; ++j) {
                const Eigen::Vector3d d = p - supports[std::size_t(j)];
                J.row(j) = d.normalized().transpose();
                left[j] = lengths[k][j] - d.norm();
            }
            p += J.colPivHouseholderQr().solve(left);
        }
        for (int j = 0; j < 5; ++j) left[j] = lengths[k][j] - (p - supports[std::size_t(j)]).norm();
        return {p, left.squaredNorm()};
    }
};

TEST(BallbarLengths, GiveTheLeastSquaresPlacesAndTheFactorOfTheirResiduals) {
    FiveBars bars(0.006);
    const UncertaintyResult result = bars.run("stated");
    EXPECT_TRUE(bars.warns());
    double squares = 0.0;
    for (std::size_t k = 0; k < bars.points.size(); ++k) {
        const auto [p, left] = bars.by_hand(k);
        squares += left;
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(1e3 * result.outputs[3 * k + c].first_order.estimate, p[Eigen::Index(c)], 1e-6);
    }
    const auto readings = bars.prepare()->model->redundant_readings();
    ASSERT_TRUE(readings);
    ASSERT_EQ(readings->figures.size(), 1u);
    EXPECT_EQ(readings->figures[0].name.english(), "readings of the bars");
    const evidence::Seen seen = evidence::see(*readings);
    ASSERT_TRUE(seen.found);
    // Two lengths of each point are more than it needs.
    EXPECT_EQ(seen.degrees_of_freedom, 40);
    EXPECT_NEAR(seen.figures[0].square, squares / 40.0 / (0.002 * 0.002), 1e-6 * seen.figures[0].square);
    EXPECT_EQ(seen.figures[0].verdict, evidence::Verdict::larger);
    ASSERT_EQ(readings->abscissas.size(), 2u);
    EXPECT_NEAR(readings->abscissas[0].values[1], 1e-3 * bars.lengths[0][1], 1e-4);
}

TEST(BallbarLengths, AsSeenScalesWhatRestsOnThem) {
    FiveBars bars(0.006);
    const double factor = evidence::see(*bars.prepare()->model->redundant_readings()).figures[0].factor;
    const UncertaintyResult stated = bars.run("stated"), seen = bars.run("seen");
    EXPECT_FALSE(bars.warns());
    for (std::size_t j = 0; j < stated.outputs.size(); ++j) {
        const double u = factor * stated.outputs[j].first_order.standard_uncertainty;
        EXPECT_NEAR(seen.outputs[j].first_order.standard_uncertainty, u, 1e-6 * u);
        EXPECT_NEAR(seen.outputs[j].first_order.effective_degrees_of_freedom, 40.0, 1e-4);
    }
}

TEST(BallbarLengths, ThatAgreeAreNotWarnedOf) {
    FiveBars bars(0.002);
    ASSERT_TRUE(bars.prepare());
    EXPECT_FALSE(bars.warns());
}

TEST(BallbarLengths, AreRefusedWhereSomeAreMissingOrDoNotMeet) {
    const auto refusal = [](FiveBars& bars) {
        EXPECT_EQ(bars.prepare(), nullptr);
        for (const Problem& problem : bars.problems.items())
            if (problem.severity == Severity::error) return problem.message.english();
        return std::string();
    };
    FiveBars missing(0.0), apart(0.0);
    missing.lengths[3].conservativeResize(4);
    EXPECT_EQ(refusal(missing), "point P4 has no length of bar 5");
    apart.lengths[2][0] = 10.0;
    EXPECT_EQ(refusal(apart).find("the lengths of the first three bars do not meet at point P3"), 0u);
}

}  // namespace
}  // namespace covaria::lengths_test
