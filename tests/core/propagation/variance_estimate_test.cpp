// Components that rest on one estimate of variance: degrees of freedom and draws.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/math/special_quantiles.h"
#include "core/propagation/draw_plan.h"
#include "core/propagation/engine.h"
#include "core/quantity/effective_degrees.h"
#include "test_models.h"

namespace covaria::test::variance_estimate_test {
namespace {

using detail::DrawPlan;

InputSet members_of_one(double nu, const std::vector<double>& scales) {
    InputSet inputs;
    for (std::size_t i = 0; i < scales.size(); ++i) {
        add_quantity(inputs, "x" + std::to_string(i + 1), Distribution::normal(scales[i]), nu);
        inputs.rest_on_estimate("s", i);
    }
    return inputs;
}

/// Values of all quantities, trial by trial, in blocks of odd lengths.
std::vector<std::vector<double>> drawn(const InputSet& inputs, std::size_t trials, std::uint64_t seed = 1) {
    const auto correlations = resolved_correlations(inputs);
    EXPECT_TRUE(correlations) << correlations.error().message.english();
    const DrawPlan plan(inputs, *correlations);
    detail::TrialRows rows(inputs.quantities.size());
    detail::DrawWorkspace workspace(plan.latent_rows());
    std::vector<std::vector<double>> x(inputs.quantities.size());
    for (std::size_t first = 0, count = 0; first < trials; first += count) {
        count = std::min(trials - first, detail::block_trials - (first / 7) % 5);
        plan.draw(seed, first, count, rows, workspace);
        for (std::size_t i = 0; i < x.size(); ++i) x[i].insert(x[i].end(), rows.row(i), rows.row(i) + count);
    }
    return x;
}

double part_beyond(const std::vector<double>& values, double limit) {
    double n = 0.0;
    for (const double v : values) n += std::abs(v) > limit;
    return n / static_cast<double>(values.size());
}

void expect_part(double part, double probability, double trials, const std::string& what) {
    EXPECT_NEAR(part, probability, 4.0 * std::sqrt(probability * (1.0 - probability) / trials)) << what;
}

// Any linear combination of a multivariate t distribution is a t distribution, with the same nu.
TEST(VarianceEstimate, LinearCombinationsOfMembersAreStudentT) {
    constexpr std::size_t trials = 200'000;
    for (const double nu : {1.5, 3.0, 12.0}) {
        InputSet inputs = members_of_one(nu, {1.0, 2.0, 0.5, 3.0});
        inputs.correlations = {{0, 1, 0.6}, {1, 2, -0.3}};
        const auto x = drawn(inputs, trials);
        for (const Eigen::Vector4d& c : {Eigen::Vector4d(1, 0, 0, 0), Eigen::Vector4d(0, 0, 0, 1),
                                         Eigen::Vector4d(1, 1, 1, 1), Eigen::Vector4d(2, -1, 3, 0.5)}) {
            Eigen::Matrix4d covariance = Eigen::Vector4d(1.0, 4.0, 0.25, 9.0).asDiagonal();
            covariance(0, 1) = covariance(1, 0) = 0.6 * 2.0;
            covariance(1, 2) = covariance(2, 1) = -0.3 * 1.0;
            const double scale = std::sqrt(c.dot(covariance * c));
            std::vector<double> sum(trials, 0.0);
            for (std::size_t t = 0; t < trials; ++t)
                for (std::size_t i = 0; i < 4; ++i) sum[t] += c[static_cast<Eigen::Index>(i)] * x[i][t];
            for (const double p : {0.5, 0.9, 0.975, 0.999, 0.9999})
                expect_part(part_beyond(sum, scale * t_quantile(p, nu)), 2.0 * (1.0 - p), trials,
                            "nu " + std::to_string(nu) + ", p " + std::to_string(p));
        }
    }
}

// P(|x1| > q, |x2| > q) of uncorrelated members, q the .975 quantile: scipy.integrate.quad over chi^2 of
// 4 (1 - Phi(q sqrt(chi^2/nu)))^2.
TEST(VarianceEstimate, UncorrelatedMembersAreNotIndependent) {
    constexpr std::size_t trials = 200'000;
    const std::pair<double, double> expected[] = {{2, 0.01899198}, {3, 0.01376669}, {8, 0.00640277}};
    for (const auto& [nu, probability] : expected) {
        const auto x = drawn(members_of_one(nu, {1.0, 1.0}), trials);
        const double q = t_quantile(0.975, nu);
        double n = 0.0;
        for (std::size_t t = 0; t < trials; ++t) n += std::abs(x[0][t]) > q && std::abs(x[1][t]) > q;
        expect_part(n / trials, probability, trials, std::to_string(nu));
    }
}

TEST(VarianceEstimate, StandardDeviationOfAMember) {
    const auto result =
        evaluate(sum_model(members_of_one(12.0, {3.0, 4.0})), members_of_one(12.0, {3.0, 4.0}), [] {
            EvaluationOptions options;
            options.trials = 1'000'000;
            return options;
        }());
    ASSERT_TRUE(result) << result.error().message.english();
    const OutputResult& y = result->outputs[0];
    EXPECT_NEAR(y.first_order.effective_degrees_of_freedom, 12.0, 1e-12);
    EXPECT_NEAR(y.first_order.standard_uncertainty, 5.0, 1e-12);
    EXPECT_NEAR(y.monte_carlo->standard_uncertainty, 5.0 * std::sqrt(12.0 / 10.0), 4.0 * 5.0 * 1.2e-3);
    // Half the width of the interval is that of first order: k u with one and the same nu.
    EXPECT_NEAR(0.5 * (y.monte_carlo->symmetric.high - y.monte_carlo->symmetric.low),
                y.first_order.expanded_uncertainty, 0.05);
    EXPECT_TRUE(result->warnings.empty());
}

TEST(VarianceEstimate, ComponentsWithFiniteDegreesOfFreedomAreDrawnAsStudentT) {
    constexpr std::size_t trials = 200'000;
    InputSet inputs;
    add_quantity(inputs, "normal", Distribution::of(Normal{5.0, 2.0}), 3.0);
    add_quantity(inputs, "asked for", Distribution::of(Normal{5.0, 2.0}), 3.0);
    inputs.components[1].normal_draws = true;
    add_quantity(inputs, "t with fewer", Distribution::of(StudentT{5.0, 2.0, 9.0}), 3.0);
    auto x = drawn(inputs, trials);
    for (auto& values : x)
        for (double& v : values) v -= 5.0;
    const double limit = 2.0 * t_quantile(0.975, 3.0);
    expect_part(part_beyond(x[0], limit), 0.05, trials, "normal");
    expect_part(part_beyond(x[1], limit), 0.001462, trials, "asked for");  // 2 Phi(-3.18245)
    expect_part(part_beyond(x[2], limit), 0.05, trials, "t with fewer");
}

TEST(VarianceEstimate, HeldMembersLeaveTheDrawsOfOthersAlone) {
    InputSet inputs = members_of_one(3.0, {1.0, 2.0, 3.0});
    const auto all = drawn(inputs, 3000);
    inputs.components[0].held = true;
    const auto without = drawn(inputs, 3000);
    EXPECT_EQ(all[1], without[1]);
    EXPECT_EQ(all[2], without[2]);
    EXPECT_EQ(without[0], std::vector<double>(3000, 0.0));
    const auto replayed = replay_trials(sum_model(inputs), inputs, 1, 2000, 10);
    ASSERT_TRUE(replayed);
    for (int t = 0; t < 10; ++t)
        EXPECT_EQ(replayed->inputs(1, t), without[1][2000 + static_cast<std::size_t>(t)]);
}

TEST(VarianceEstimate, MembersAreOneFactorOfSobol) {
    InputSet inputs = members_of_one(30.0, {1.0, 1.0});
    add_quantity(inputs, "other", Distribution::normal(1.0));
    EvaluationOptions options;
    options.trials = 10'000;
    options.sobol_trials = 50'000;
    const auto result = evaluate(sum_model(inputs), inputs, options);
    ASSERT_TRUE(result);
    ASSERT_EQ(result->sobol.at(0).size(), 2u);
    EXPECT_EQ(result->sobol[0][0].name, "x1, x2");
    const double members = 2.0 * 30.0 / 28.0;
    EXPECT_NEAR(result->sobol[0][0].total, members / (members + 1.0),
                4.0 * result->sobol[0][0].total_standard_error);
}

TEST(VarianceEstimate, RefusesWhatCannotShareIt) {
    InputSet inputs = members_of_one(3.0, {1.0, 2.0});
    inputs.components[1].degrees_of_freedom = 4.0;
    ASSERT_FALSE(resolved_correlations(inputs));
    EXPECT_NE(resolved_correlations(inputs).error().message.english().find(
                  "\"x2\" rests on the estimate of variance"),
              std::string::npos);
    inputs.components[1].degrees_of_freedom = 3.0;
    EXPECT_TRUE(resolved_correlations(inputs));
    inputs.components[1].distribution = Distribution::of(Rectangular{-1.0, 1.0});
    EXPECT_FALSE(resolved_correlations(inputs));
    inputs = members_of_one(3.0, {1.0, 2.0});
    inputs.rest_on_estimate("another", 1);
    EXPECT_FALSE(resolved_correlations(inputs));
}

// u^2 of random budgets computed again from random estimates of variance: 2 u^4/nu_eff is its variance.
TEST(WelchSatterthwaite, IsTheVarianceOfEstimatedVariances) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0.1, 2.0);
    for (int set_up = 0; set_up < 10; ++set_up) {
        InputSet inputs;
        double nus[4], largest_nu = 0.0;
        for (double& nu : nus) nu = std::floor(1.0 + 6.0 * uniform(random)), largest_nu += nu;
        Eigen::VectorXd u(8);
        for (std::size_t c = 0; c < 8; ++c) {
            u[static_cast<Eigen::Index>(c)] = uniform(random);
            add_quantity(inputs, "x" + std::to_string(c),
                         Distribution::normal(u[static_cast<Eigen::Index>(c)]), nus[c % 4]);
            if (c % 4 < 3) inputs.rest_on_estimate("s" + std::to_string(c % 4), c);
        }
        inputs.correlations = {{0, 4, 0.8}, {1, 5, -0.5}};
        const auto law = evaluate_first_order(sum_model(inputs), inputs, {});
        ASSERT_TRUE(law) << law.error().message.english();
        const double u2 = std::pow(law->outputs[0].first_order.standard_uncertainty, 2);
        const double nu = law->outputs[0].first_order.effective_degrees_of_freedom;
        EXPECT_LE(nu, largest_nu + nus[3] + 1e-9) << "more than all distinct estimates together";
        double squares = 0.0, sum = 0.0;
        constexpr int repeats = 200'000;
        for (int repeat = 0; repeat < repeats; ++repeat) {
            double of_estimate[5], v2 = 0.0;
            for (int e = 0; e < 5; ++e) {
                const double f = nus[e % 4 == 3 || e == 4 ? 3 : e];
                of_estimate[e] = std::sqrt(std::chi_squared_distribution<double>(f)(random) / f);
            }
            Eigen::VectorXd a(8);
            for (int c = 0; c < 8; ++c) a[c] = u[c] * of_estimate[c == 7 ? 4 : c % 4];
            v2 = a.squaredNorm() + 2.0 * (0.8 * a[0] * a[4] - 0.5 * a[1] * a[5]);
            sum += v2, squares += v2 * v2;
        }
        const double variance = squares / repeats - std::pow(sum / repeats, 2);
        EXPECT_NEAR(sum / repeats, u2, 0.02 * u2);
        EXPECT_NEAR(variance, 2.0 * u2 * u2 / nu, 0.1 * variance) << set_up;
    }
}

}  // namespace
}  // namespace covaria::test::variance_estimate_test
