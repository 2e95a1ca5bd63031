// The law of propagation without the sensitivity coefficients in memory: what is stated is the same.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/propagation/condensed_law.h"
#include "core/propagation/contributions.h"
#include "core/result/uncertainty_result.h"

namespace covaria::condensed_law_test {
namespace {

using namespace detail;

/// y = C x, with the rows of C one at a time; the row `without` is not known.
class RowModel : public MeasurementModel {
public:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    RowModel(InputSet inputs, std::size_t points, std::size_t without = none)
        : inputs_(std::move(inputs)), without_(without) {
        std::mt19937_64 random(7);
        std::normal_distribution<double> normal;
        C_.resize(static_cast<Eigen::Index>(3 * points),
                  static_cast<Eigen::Index>(inputs_.quantities.size()));
        for (double& c : C_.reshaped()) c = normal(random);
        C_.col(2).setZero();
        for (std::size_t j = 0; j < 3 * points; ++j)
            outputs_.push_back({.symbol = std::string(1, "xyz"[j % 3]),
                                .name = "coordinate",
                                .group = Name("P" + std::to_string(j / 3))});
    }
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return {}; }
    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        Eigen::Map<Eigen::VectorXd>(y.data(), C_.rows()) =
            C_ * Eigen::Map<const Eigen::VectorXd>(x.data(), C_.cols());
        return true;
    }
    bool sensitivities(std::span<const double> x, SensitivityRows& rows) const override {
        rows.assign(outputs_.size(), {});
        for (std::size_t j = 0; j < rows.size(); ++j)
            static_cast<void>(sensitivity_source(x)->row(j, rows[j]));
        return true;
    }
    std::unique_ptr<const SensitivitySource> sensitivity_source(std::span<const double>) const override {
        class Source : public SensitivitySource {
        public:
            explicit Source(const RowModel& model) : model_(model) {}
            bool row(std::size_t output, std::vector<Sensitivity>& row) const override {
                row.clear();
                for (Eigen::Index i = 0; i < model_.C_.cols(); ++i)
                    if (const double c = model_.C_(static_cast<Eigen::Index>(output), i); c != 0.0)
                        row.push_back({static_cast<std::size_t>(i), c});
                return output != model_.without_;
            }

        private:
            const RowModel& model_;
        };
        return std::make_unique<Source>(*this);
    }

private:
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    std::size_t without_;
    Eigen::MatrixXd C_;
};

/// Readings of three stations, some with few degrees of freedom, two of them of one estimate of variance.
InputSet readings(bool correlated) {
    InputSet inputs;
    for (std::size_t i = 0; i < 90; ++i) {
        const std::string symbol = "l_" + std::to_string(i), station = "S" + std::to_string(i % 3);
        UncertaintyComponent component{.id = symbol,
                                       .name = symbol,
                                       .distribution = Distribution::normal(0.5 + 0.1 * double(i % 7)),
                                       .contributor = i % 3 == 0 ? "tracker" : ""};
        if (i % 5 == 0) component.degrees_of_freedom = 4.0 + double(i);
        component.held = i == 11;
        inputs.add(
            {.symbol = symbol, .name = symbol, .group = Name(station), .tags = {{"analysis", station}}},
            {component});
    }
    inputs.rest_on_estimate("series", 0);
    inputs.components[20].degrees_of_freedom = inputs.components[0].degrees_of_freedom;
    inputs.rest_on_estimate("series", 20);
    if (correlated) inputs.correlations = {{1, 2, 0.4}, {30, 31, -0.7}, {5, 80, 0.9}};
    return inputs;
}

LawOfPropagation condensed(const RowModel& model, std::size_t most_rows = 0) {
    return law_of_propagation(model, model.inputs(), model.inputs().correlations, {0, most_rows}).value();
}

LawOfPropagation whole(const RowModel& model) {
    return law_of_propagation(model, model.inputs(), model.inputs().correlations).value();
}

/// The largest difference of covariances that are kept, as a part of the variances.
double difference(const LawOfPropagation& a, const LawOfPropagation& b) {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < a.estimate.size(); ++i)
        for (Eigen::Index j = 0; j < a.estimate.size(); ++j)
            if (const double expected = b.covariance(i, j); !std::isnan(expected))
                largest = std::max(largest, std::abs(a.covariance(i, j) - expected) /
                                                std::sqrt(b.covariance(i, i) * b.covariance(j, j)));
    return largest;
}

class CondensedLaw : public testing::TestWithParam<std::tuple<bool, std::size_t>> {};

TEST_P(CondensedLaw, StatesWhatTheWholeLawStates) {
    const auto [correlated, points] = GetParam();
    const RowModel model(readings(correlated), points);
    const LawOfPropagation law = condensed(model), expected = whole(model);
    ASSERT_TRUE(law.condensed);
    EXPECT_TRUE(law.terms.empty() && law.sensitivities.empty()) << "nothing large is kept";
    EXPECT_EQ(law.estimate, expected.estimate);
    EXPECT_LT(difference(law, expected), 1e-13);
    for (Eigen::Index j = 0; j < law.estimate.size(); ++j)
        EXPECT_NEAR(law.degrees_of_freedom(j), expected.degrees_of_freedom(j),
                    1e-11 * expected.degrees_of_freedom(j));
    EXPECT_EQ(law.degrees_of_freedom_approximate, expected.degrees_of_freedom_approximate);

    const auto contributors = contributors_of(model.inputs(), law, model.inputs().correlations),
               expected_contributors = contributors_of(model.inputs(), expected, model.inputs().correlations);
    ASSERT_EQ(contributors.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t j = 0; j < 3 * points; ++j) {
            const auto& [u, of_none, failed] = contributors[k].without;
            EXPECT_NEAR(u[j], expected_contributors[k].without.first_order[j], 1e-12 * u[j]);
        }
}

TEST_P(CondensedLaw, KeepsTheLargestComponentsAndSumsTheOthersByTheirGroup) {
    const auto [correlated, points] = GetParam();
    const RowModel model(readings(correlated), points);
    const UncertaintyBudget budget = budget_of(model.inputs(), condensed(model)),
                            expected = budget_of(model.inputs(), whole(model));
    const std::size_t components = model.inputs().components.size();
    for (std::size_t j = 0; j < 3 * points; ++j) {
        std::vector<std::size_t> kept, first;
        double share = 0.0;
        for (const BudgetRow& row : budget.rows[j]) {
            share += row.share;
            if (!budget.components[row.component].is_rest) kept.push_back(row.component);
        }
        EXPECT_NEAR(share, 1.0, 1e-12);
        EXPECT_TRUE(std::ranges::is_sorted(budget.rows[j], std::greater(),
                                           [](const BudgetRow& row) { return std::abs(row.share); }));
        ASSERT_EQ(kept.size(), 20u);
        for (std::size_t k = 0; k < 20; ++k) first.push_back(expected.rows[j][k].component);
        EXPECT_EQ(kept, first);
        const auto groups = contributions_by_group(budget, j, "analysis"),
                   expected_groups = contributions_by_group(expected, j, "analysis");
        ASSERT_EQ(groups.size(), 3u);
        for (std::size_t g = 0; g < 3; ++g) {
            EXPECT_EQ(groups[g].group, expected_groups[g].group);
            EXPECT_NEAR(groups[g].share, expected_groups[g].share, 1e-12);
            EXPECT_NEAR(groups[g].contribution, expected_groups[g].contribution,
                        1e-12 * expected_groups[g].contribution);
        }
    }
    EXPECT_EQ(budget.components[components].name.english(), "further components of S0");
}

INSTANTIATE_TEST_SUITE_P(OneBlockAndSeveral, CondensedLaw,
                         testing::Combine(testing::Bool(), testing::Values(4u, 501u)));

TEST(CondensedLawOfPropagation, HasEveryComponentWhereThereIsRoom) {
    const RowModel model(readings(false), 4);
    const UncertaintyBudget budget = budget_of(model.inputs(), condensed(model, 12 * 90)),
                            expected = budget_of(model.inputs(), whole(model));
    for (std::size_t j = 0; j < 12; ++j) {
        ASSERT_EQ(budget.rows[j].size(), expected.rows[j].size());
        for (std::size_t k = 0; k < budget.rows[j].size(); ++k)
            EXPECT_EQ(budget.rows[j][k].component, expected.rows[j][k].component);
    }
}

TEST(CondensedLawOfPropagation, SaysNothingOfAnOutputWithoutSensitivities) {
    const RowModel model(readings(false), 501, 7);
    const LawOfPropagation law = condensed(model);
    EXPECT_FALSE(law.differentiable[7]);
    EXPECT_TRUE(std::isnan(law.covariance(7, 7)));
    EXPECT_TRUE(law.differentiable[6] && law.covariance(6, 6) > 0.0);
    EXPECT_TRUE(budget_of(model.inputs(), law).rows[7].empty());
}

}  // namespace
}  // namespace covaria::condensed_law_test
