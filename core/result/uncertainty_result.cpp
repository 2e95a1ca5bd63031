// Groups of outputs and the correlation matrix of a covariance matrix.
#include "core/result/uncertainty_result.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace covaria {

std::vector<std::size_t> outputs_of_group(const std::vector<OutputQuantity>& outputs,
                                          const std::string& group) {
    std::vector<std::size_t> indices;
    for (std::size_t j = 0; j < outputs.size(); ++j)
        if (outputs[j].group == group) indices.push_back(j);
    return indices;
}

std::vector<Name> groups_of(const std::vector<OutputQuantity>& outputs) {
    std::vector<Name> groups;
    for (const OutputQuantity& output : outputs)
        if (std::find(groups.begin(), groups.end(), output.group) == groups.end())
            groups.push_back(output.group);
    return groups;
}

std::string_view key_of(VarianceReduction reduction) {
    static constexpr std::string_view keys[] = {"none", "control-variate", "sobol"};
    return keys[static_cast<int>(reduction)];
}

OutputCovariance existing_covariance(const UncertaintyResult& result) {
    OutputCovariance existing = result.covariance;
    for (Eigen::Index j = 0; j < existing.rows(); ++j)
        if (std::isinf(result.outputs[static_cast<std::size_t>(j)].standard_uncertainty))
            existing.set(j, std::numeric_limits<double>::quiet_NaN());
    return existing;
}

const OutputCovariance& first_order_covariance(const UncertaintyResult& result) {
    return result.covariance_before_trials ? *result.covariance_before_trials : result.covariance;
}

std::optional<double> least_gain(const UncertaintyResult& result) {
    std::optional<double> least;
    for (const OutputResult& output : result.outputs) {
        if (!output.monte_carlo || !output.monte_carlo->reduced) continue;
        if (output.quantity.role != OutputRole::measurand) continue;
        const OutputFigures& gains = output.monte_carlo->reduced->gains;
        for (const double gain : {gains.low, gains.high})
            if (std::isfinite(gain)) least = std::min(least.value_or(gain), gain);
    }
    return least;
}

std::vector<std::string> groupings_of(const UncertaintyBudget& budget) {
    std::vector<std::string> groupings;
    for (const BudgetComponent& component : budget.components)
        for (const GroupTag& tag : component.tags)
            if (std::find(groupings.begin(), groupings.end(), tag.grouping) == groupings.end())
                groupings.push_back(tag.grouping);
    return groupings;
}

std::vector<GroupContribution> contributions_by_group(const UncertaintyBudget& budget, std::size_t output,
                                                      const std::string& grouping) {
    std::vector<GroupContribution> groups;
    for (const BudgetRow& row : budget.rows[output]) {
        Name group = group_without_tag;
        for (const GroupTag& tag : budget.components[row.component].tags)
            if (tag.grouping == grouping) group = tag.group;
        auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](const GroupContribution& known) { return known.group == group; });
        if (found == groups.end()) found = groups.insert(groups.end(), {group, 0.0, 0.0});
        found->contribution = std::hypot(found->contribution, row.contribution);
        found->share += row.share;
    }
    std::stable_sort(
        groups.begin(), groups.end(),
        [](const GroupContribution& a, const GroupContribution& b) { return a.share > b.share; });
    return groups;
}

Eigen::MatrixXd correlation_of(const Eigen::MatrixXd& covariance) {
    Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols());
    for (Eigen::Index a = 0; a < covariance.rows(); ++a)
        for (Eigen::Index b = 0; b < a; ++b) {
            // Two square roots: the product of two small variances may underflow.
            const double product = std::sqrt(covariance(a, a)) * std::sqrt(covariance(b, b));
            if (product > 0)
                correlation(a, b) = correlation(b, a) = std::clamp(covariance(a, b) / product, -1.0, 1.0);
        }
    return correlation;
}

}  // namespace covaria
