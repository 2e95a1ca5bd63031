// The cheapest reductions: against a closed solution, against another solver, in a project.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>
#include <random>

#include "core/design/cheapest_reductions.h"
#include "core/design/design.h"
#include "core/views/design_results.h"
#include "tests/core/made.h"

namespace covaria::reductions_test {
namespace {

using detail::cheapest_reductions;
using detail::CheapestReductions;
using detail::cost_of;
using detail::ReductionTask;

DesignReduction reduction(double price, PriceLaw law, double least) {
    DesignReduction made;
    made.price = price;
    made.law = law;
    made.number.from = least;
    return made;
}

double cost_of_all(const ReductionTask& task, const std::vector<double>& factors) {
    double cost = 0.0;
    for (std::size_t j = 0; j < factors.size(); ++j) cost += cost_of(task.reductions[j], factors[j]);
    return cost;
}

Eigen::VectorXd variances(const ReductionTask& task, const std::vector<double>& factors) {
    return task.rest +
           task.part * Eigen::Map<const Eigen::VectorXd>(factors.data(), task.part.cols()).cwiseAbs2();
}

TEST(PriceLaws, CostNothingUnchangedAndThePriceAtTheFirstHalving) {
    for (const PriceLaw law : {PriceLaw::inverse, PriceLaw::repeats, PriceLaw::logarithmic}) {
        EXPECT_NEAR(cost_of(reduction(7.0, law, 0.1), 1.0), 0.0, 1e-15);
        EXPECT_NEAR(cost_of(reduction(7.0, law, 0.1), 0.5), 7.0, 1e-14);
    }
    EXPECT_NEAR(cost_of(reduction(6.0, PriceLaw::repeats, 0.1), 1.0 / std::sqrt(10.0)), 18.0, 1e-12);
    EXPECT_NEAR(cost_of(reduction(6.0, PriceLaw::logarithmic, 0.1), 0.125), 18.0, 1e-13);
    EXPECT_NEAR(cost_of(reduction(6.0, PriceLaw::inverse, 0.1), 0.25), 18.0, 1e-13);
}

/// Neyman's allocation: v_j = sqrt(p_j/a_j) / sum of sqrt(p_i a_i), by Cauchy and Schwarz.
TEST(CheapestReductionsTest, OfReadingsAreNeymansAllocation) {
    ReductionTask task;
    task.reductions = {reduction(30.0, PriceLaw::repeats, 0.01), reduction(3.0, PriceLaw::repeats, 0.01),
                       reduction(12.0, PriceLaw::repeats, 0.01)};
    task.part.resize(1, 3);
    task.part << 4.0, 1.5, 2.0;
    task.rest = Eigen::VectorXd::Constant(1, 0.2);
    const double limit = 0.8;
    double sum = 0.0, prices = 0.0;
    for (int j = 0; j < 3; ++j) {
        sum += std::sqrt(task.reductions[std::size_t(j)].price * task.part(0, j));
        prices += task.reductions[std::size_t(j)].price;
    }
    const CheapestReductions found = cheapest_reductions(task);
    ASSERT_TRUE(found.possible);
    for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(
            found.factors[std::size_t(j)],
            std::sqrt(std::sqrt(task.reductions[std::size_t(j)].price / task.part(0, j)) * limit / sum),
            1e-9);
    EXPECT_NEAR(found.cost, (sum * sum / limit - prices) / 3.0, 1e-9 * found.cost);
    EXPECT_NEAR(found.multipliers(0), sum * sum / (3.0 * limit * limit), 1e-8 * found.multipliers(0));
}

/// d cost / d f².
double slope_of(const DesignReduction& r, double f) {
    const double by_f = r.law == PriceLaw::repeats   ? -2.0 * r.price / (3.0 * std::pow(f, 3))
                        : r.law == PriceLaw::inverse ? -r.price / (f * f)
                                                     : -r.price / (std::log(2.0) * f);
    return by_f / (2.0 * f);
}

/// The task for NLopt in f², with costs relative to the sum of the prices.
struct Nlopt {
    const ReductionTask& task;
    double unit;
    static std::vector<double> roots(const double* v, std::size_t n) {
        std::vector<double> f;
        for (std::size_t j = 0; j < n; ++j) f.push_back(std::sqrt(v[j]));
        return f;
    }
    static double cost(const std::vector<double>& v, std::vector<double>& slope, void* self) {
        const Nlopt& data = *static_cast<Nlopt*>(self);
        const std::vector<double> f = roots(v.data(), v.size());
        for (std::size_t j = 0; j < slope.size(); ++j)
            slope[j] = slope_of(data.task.reductions[j], f[j]) / data.unit;
        return cost_of_all(data.task, f) / data.unit;
    }
    static void limits(unsigned k, double* above, unsigned n, const double* v, double* slope, void* self) {
        const ReductionTask& task = static_cast<Nlopt*>(self)->task;
        const Eigen::VectorXd whole = variances(task, roots(v, n));
        for (unsigned i = 0; i < k; ++i) above[i] = whole(i) - 1.0;
        for (unsigned i = 0; slope && i < k; ++i)
            for (unsigned j = 0; j < n; ++j) slope[i * n + j] = task.part(i, j);
    }
};

TEST(CheapestReductionsTest, AreThoseOfAnotherSolverAndMeetTheConditionsOfOptimality) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    int solved = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const std::size_t n = 2 + random() % 7;
        const Eigen::Index outputs = 1 + Eigen::Index(random() % 4);
        ReductionTask task;
        for (std::size_t j = 0; j < n; ++j)
            task.reductions.push_back(
                reduction(std::pow(10.0, 3.0 * uniform(random)), static_cast<PriceLaw>(random() % 3), 0.1));
        task.part.resize(outputs, Eigen::Index(n));
        for (Eigen::Index i = 0; i < task.part.size(); ++i)
            task.part.data()[i] = 3.0 * std::pow(uniform(random), 3);
        task.rest = Eigen::VectorXd::Constant(outputs, 0.3 * uniform(random));
        const CheapestReductions found = cheapest_reductions(task);
        if (!found.possible || found.cost == 0.0) continue;
        ++solved;
        const Eigen::VectorXd v = variances(task, found.factors);
        EXPECT_LE(v.maxCoeff(), 1.0 + 1e-9);
        for (Eigen::Index k = 0; k < outputs; ++k) {
            EXPECT_GE(found.multipliers(k), 0.0);
            EXPECT_NEAR(found.multipliers(k) * (1.0 - v(k)), 0.0, 1e-6 * found.cost);
        }
        double unit = 0.0;
        for (const DesignReduction& r : task.reductions) unit += r.price;
        // The gradient of the Lagrangian vanishes, or points out of the bounds.
        for (std::size_t j = 0; j < n; ++j) {
            const double f = found.factors[j];
            const double gradient =
                slope_of(task.reductions[j], f) + task.part.col(Eigen::Index(j)).dot(found.multipliers);
            if (f < 1.0 - 1e-6) {
                EXPECT_GE(gradient, -1e-6 * unit) << "trial " << trial;
            }
            if (f > 0.1 + 1e-6) {
                EXPECT_LE(gradient, 1e-6 * unit) << "trial " << trial;
            }
        }
        Nlopt data{task, unit};
        nlopt::opt opt(nlopt::LD_MMA, static_cast<unsigned>(n));
        opt.set_lower_bounds(0.01);
        opt.set_upper_bounds(1.0);
        opt.set_min_objective(Nlopt::cost, &data);
        opt.add_inequality_mconstraint(Nlopt::limits, &data,
                                       std::vector<double>(std::size_t(outputs), 1e-10));
        opt.set_xtol_rel(1e-12);
        opt.set_maxeval(20000);
        std::vector<double> v_found;
        for (const double f : found.factors) v_found.push_back(std::clamp(0.9 * f * f, 0.01, 1.0));
        double value = 0.0;
        try {
            opt.optimize(v_found, value);
        } catch (const nlopt::roundoff_limited&) {  // it is as near as rounding lets it be
        }
        const double other = cost_of_all(task, Nlopt::roots(v_found.data(), n));
        // NLopt breaks limits by rounding only, which makes its cost smaller.
        EXPECT_LE(found.cost, other * (1.0 + 1e-6)) << "trial " << trial;
    }
    EXPECT_GT(solved, 20);
}

TEST(CheapestReductionsTest, WhatCannotBeMetIsSaidAndNothingIsPaidWhereAllIsMet) {
    ReductionTask task;
    task.reductions = {reduction(1.0, PriceLaw::inverse, 0.5)};
    task.part = Eigen::MatrixXd::Constant(1, 1, 3.0);
    task.rest = Eigen::VectorXd::Constant(1, 0.5);
    EXPECT_FALSE(cheapest_reductions(task).possible);
    EXPECT_EQ(cheapest_reductions(task).factors, std::vector<double>{0.5});
    task.part(0, 0) = 0.4;
    EXPECT_TRUE(cheapest_reductions(task).possible);
    EXPECT_EQ(cheapest_reductions(task).cost, 0.0);
}

Project two_components(double target_mm, const std::string& nu = "null") {
    const LoadedProject loaded = parse_project(
        R"({"format":"covaria","schemaVersion":1,"title":"t","assets":[],"analyses":[{"id":"a",
          "model":"measurement-equation","setup":{"equations":["y = p + q"],
          "outputs":{"columns":["symbol","unit"],"rows":[["y","mm"]]},
          "quantities":{"columns":["symbol","value","unit","statement","a","nu"],"rows":[
          ["p",1,"mm","standard",3,)" +
            nu + R"(],["q",2,"mm","standard",4,null]]}},
          "requirements":[{"symbol":"y","targetUncertainty":{"value":)" +
            std::to_string(target_mm) +
            R"(,"unit":"mm"}}],"designs":[{"id":"d","reductions":[
          {"target":"/inputs/p/components","least":0.05,"price":100,"law":"repeats"},
          {"target":"/inputs/q/components","least":0.05,"price":50,"law":"repeats"}]}]}]})",
        {}, "test");
    for (const Problem& p : loaded.problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    return loaded.project;
}

Result<DesignResult> run(const Project& project) {
    Problems problems;
    const auto prepared = prepare_design(MadeProject::make(project), "a", "d", problems);
    EXPECT_TRUE(prepared) << first_error(problems, "");
    return prepared ? run_design(*prepared)
                    : Result<DesignResult>(fail(ErrorCode::bad_input, "not prepared"));
}

TEST(ReverseQuestion, IsAnsweredForAProjectWithThePriceOfItsTarget) {
    const auto found = run(two_components(5.0));
    ASSERT_TRUE(found) << found.error().message.english();
    EXPECT_TRUE(found->met());
    const double k = found->goals[0].after / 5e-3;
    EXPECT_NEAR(k, 1.0, 1e-9) << "not better than it has to be";
    const double coverage = *found->goals[0].before / 5e-3;  // u is 5 mm
    const double limit = std::pow(5.0 / coverage, 2), sum = std::sqrt(100.0 * 9.0) + std::sqrt(50.0 * 16.0);
    EXPECT_NEAR(*found->cost, (sum * sum / limit - 150.0) / 3.0, 1e-6);
    EXPECT_NEAR(*found->goals[0].price_of_target, 2.0 * sum * sum / (3.0 * limit) / 5e-3, 1e-3);
    ASSERT_GT(found->front.size(), 5u);
    for (std::size_t i = 1; i < found->front.size(); ++i)
        EXPECT_LT(found->front[i].cost, found->front[i - 1].cost) << "wider targets cost less";
    EXPECT_NE(design_text(*found).find("less"), std::string::npos);
}

TEST(ReverseQuestion, CoverageFactorsAreThoseOfTheSolution) {
    const auto found = run(two_components(8.0, "6"));
    ASSERT_TRUE(found) << found.error().message.english();
    EXPECT_NEAR(found->goals[0].after, 8e-3, 1e-10);
}

TEST(ReverseQuestion, WhatCannotBeMetHasTheBestThatIsReached) {
    const auto found = run(two_components(0.1));
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->met());
    EXPECT_EQ(found->values[0].chosen, 0.05);
    EXPECT_NE(design_text(*found).find("the target of U(y) is not met: the best design found reaches"),
              std::string::npos);
}

TEST(ReverseQuestion, IsTakenOver) {
    const Project project = two_components(5.0);
    Problems problems;
    const auto prepared = prepare_design(MadeProject::make(project), "a", "d", problems);
    ASSERT_TRUE(prepared);
    const auto found = run_design(*prepared);
    ASSERT_TRUE(found);
    const auto taken = take_over(project, *prepared, *found);
    ASSERT_TRUE(taken) << taken.error().message.english();
    const auto again = run(*taken);
    ASSERT_TRUE(again);
    EXPECT_NEAR(*again->goals[0].before, 5e-3, 1e-9);
    EXPECT_NEAR(*again->cost, 0.0, 1e-6);
}

}  // namespace
}  // namespace covaria::reductions_test
