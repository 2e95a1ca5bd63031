// Results that follow from the uncertainties that residuals see: poses, identification, circle points,
// curves.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/resource_path.h"
#include "core/evidence/as_seen.h"
#include "core/math/rotation.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace covaria::as_seen_test {
namespace {

using evidence::UncertaintiesFrom;

struct Case {
    Case(const char* file, std::string analysis)
        : project(load_project(data_directory() / "projects" / file).project), id(std::move(analysis)) {}

    covaria::Setup& setup() {
        for (AnalysisEntry& analysis : project.analyses)
            if (analysis.id == id) return analysis.setup;
        throw std::out_of_range(id);
    }
    std::shared_ptr<const PreparedAnalysis> prepare() {
        problems = {};
        auto prepared = made_analysis(project, id, problems);
        if (!prepared)
            for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
        return prepared;
    }
    UncertaintyResult run(const std::string& uncertainties) {
        setup().values["uncertainties"] = uncertainties;
        for (AnalysisEntry& analysis : project.analyses)
            if (analysis.id == id) analysis.options.method = Method::first_order;
        return run_analysis(*prepare()).value();
    }

    Project project;
    std::string id;
    Problems problems;
};

/// Expects all uncertainties times the one factor, with its degrees of freedom.
void expect_one_factor(Case& of) {
    const UncertaintyResult stated = of.run("stated"), seen = of.run("one-factor");
    const auto readings = of.prepare()->model->redundant_readings();
    ASSERT_TRUE(readings);
    const evidence::TakenFactor one = evidence::as_seen(*readings, UncertaintiesFrom::one_factor).factors[0];
    ASSERT_TRUE(one.is_seen());
    EXPECT_GT(std::abs(one.factor - 1.0), 1e-3);
    ASSERT_EQ(stated.outputs.size(), seen.outputs.size());
    for (std::size_t j = 0; j < seen.outputs.size(); ++j) {
        const double u = one.factor * stated.outputs[j].first_order.standard_uncertainty;
        EXPECT_NEAR(seen.outputs[j].first_order.standard_uncertainty, u, 1e-6 * u) << j;
        EXPECT_NEAR(seen.outputs[j].first_order.effective_degrees_of_freedom, one.degrees_of_freedom,
                    1e-6 * one.degrees_of_freedom)
            << j;
    }
}

TEST(AsSeen, AnIdentificationFromPoses) {
    Case of("er10l-c10.covaria", "poses-measured");
    // Check poses have deviations of their own readings, which no residual sees.
    std::erase_if(std::get<SetupTable>(of.setup().values.at("poses")).rows, [](const auto& row) {
        const auto* use = std::get_if<std::string>(&row[1]);
        return use && *use == "check";
    });
    expect_one_factor(of);
}

TEST(AsSeen, CirclePoints) {
    Case of("er10l-c10.covaria", "trajectories");
    expect_one_factor(of);
}

TEST(AsSeen, TheWarningOfAnIdentificationLeadsThere) {
    Case of("er10l-c10.covaria", "poses-measured");
    of.setup().values["u_point"] = Quantity{0.005, Unit::of("mm")};
    of.prepare();
    const Problem* warning = nullptr;
    for (const Problem& problem : of.problems.items())
        if (!problem.remedies.empty()) warning = &problem;
    ASSERT_NE(warning, nullptr);
    ASSERT_EQ(warning->remedies.size(), 1u);
    EXPECT_TRUE(warning->remedies[0].values[0].place.ends_with("/setup/uncertainties"));
    of.run("seen");
    for (const Problem& problem : of.problems.items())
        EXPECT_TRUE(problem.remedies.empty()) << problem.message.english();
}

/// The size of one stated u for all points is of no consequence: the curve is the one from the residuals.
TEST(AsSeen, ACurveIsTheOneFromItsResiduals) {
    Case of("gum/h3-thermometer.covaria", {});
    of.id = of.project.analyses.front().id;
    const UncertaintyResult by_residuals = run_analysis(*of.prepare()).value();
    of.setup().values["uncertainty"] = std::string("stated");
    for (auto& row : std::get<SetupTable>(of.setup().values.at("points")).rows) row[3] = 0.001;
    for (const char* from : {"one-factor", "seen"}) {
        const UncertaintyResult seen = of.run(from);
        for (std::size_t j = 0; j < by_residuals.outputs.size(); ++j) {
            const FirstOrderOutput &a = seen.outputs[j].first_order, &b = by_residuals.outputs[j].first_order;
            if (std::string(from) == "seen") {
                // Nine degrees of freedom are too few to say.
                EXPECT_NE(a.standard_uncertainty, b.standard_uncertainty) << j;
                continue;
            }
            EXPECT_NEAR(a.standard_uncertainty, b.standard_uncertainty, 1e-9 * b.standard_uncertainty) << j;
            EXPECT_NEAR(a.effective_degrees_of_freedom, 9.0, 1e-6) << j;
        }
    }
}

/// The platform of the Stewart project, measured in each pose with twice the deviations that are stated.
TEST(AsSeen, APoseFromItsResiduals) {
    Case of("stewart-platform.covaria", "printed");
    covaria::Setup& setup = of.setup();
    const auto place = [](const std::vector<SetupCell>& row, std::size_t from) {
        return Eigen::Vector3d(std::get<double>(row[from]), std::get<double>(row[from + 1]),
                               std::get<double>(row[from + 2]));
    };
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0.0, 0.2);
    SetupTable measured;
    measured.units = {Unit(), Unit(), Unit(), Unit::of("mm"), Unit::of("mm"), Unit::of("mm")};
    const auto add = [&](const std::string& set, const SetupTable& points, const Eigen::Isometry3d& X) {
        for (const auto& row : points.rows) {
            Eigen::Vector3d p = X * place(row, 1);
            for (double& c : p) c += normal(random);
            measured.rows.push_back({set, std::get<std::string>(row[0]), 1.0, p.x(), p.y(), p.z()});
        }
    };
    const SetupTable base = std::get<SetupTable>(setup.values.at("base_points")),
                     moving = std::get<SetupTable>(setup.values.at("moving_points"));
    add("base", base, Eigen::Isometry3d::Identity());
    for (const auto& row : std::get<SetupTable>(setup.values.at("poses")).rows) {
        Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
        X.translation() = place(row, 1);
        X.linear() = rotation_from_zyx<double>(place(row, 4) * std::acos(-1.0) / 180.0);
        add(std::get<std::string>(row[0]), moving, X);
    }
    setup.values["evaluation"] = std::string("a-posteriori");
    setup.values["measured_points"] = measured;
    for (const std::string side : {"base", "moving"}) {
        setup.values[side + "_fit"] = std::string("least-squares");
        for (const char axis : {'x', 'y', 'z'})
            setup.values[side + "_u_" + axis] = Quantity{0.1, Unit::of("mm")};
    }
    const auto readings = of.prepare()->model->redundant_readings();
    ASSERT_TRUE(readings);
    const evidence::TakenFactor one = evidence::as_seen(*readings, UncertaintiesFrom::one_factor).factors[0];
    EXPECT_NEAR(one.factor, 2.0, 4.0 * 2.0 / std::sqrt(2.0 * one.degrees_of_freedom));
    EXPECT_EQ(readings->figures.front().name.english().find("base points, coordinate"), 0u);
    expect_one_factor(of);
}

}  // namespace
}  // namespace covaria::as_seen_test
