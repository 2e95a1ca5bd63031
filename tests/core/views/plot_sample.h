// A result made by hand for tests of charts: six correlated outputs of a pose with normal quantiles,
// histogram, budget and convergence.
#pragma once

#include <cmath>
#include <string>

#include "core/math/normal_quantile.h"
#include "core/result/uncertainty_result.h"

namespace covaria::test {

inline constexpr double plot_trials = 1e6;

/// The result that 10^6 trials of a normal distribution would give, without chance.
inline MonteCarloOutput normal_trials(double mean, double u) {
    MonteCarloOutput mc;
    mc.mean = mean;
    mc.standard_uncertainty = u;
    mc.standard_error_of_mean = u / std::sqrt(plot_trials);
    mc.standard_error_of_uncertainty = u / std::sqrt(2.0 * plot_trials);
    mc.symmetric = mc.shortest = {mean - 1.959964 * u, mean + 1.959964 * u};
    mc.histogram.low = mean - 5.0 * u;
    mc.histogram.high = mean + 5.0 * u;
    for (int i = 0; i < 100; ++i) {
        const double z = -5.0 + 0.1 * i;
        const double p = normal_distribution_function(z + 0.1) - normal_distribution_function(z);
        mc.histogram.counts.push_back(static_cast<std::uint64_t>(std::llround(plot_trials * p)));
    }
    for (int i = 0; i < 199; ++i) mc.quantiles.push_back(mean + u * normal_quantile((i + 0.5) / 199.0));
    mc.normality.words = "normal within 1 %";
    return mc;
}

inline void add_output(UncertaintyResult& result, const char* symbol, const char* unit, double estimate,
                       double u) {
    OutputResult output;
    output.quantity = {symbol, std::string(symbol) + " of the platform", Unit::of(unit), "pose 7"};
    output.estimate = output.first_order.estimate = estimate;
    output.standard_uncertainty = u;
    output.coverage_factor = 1.959964;
    output.expanded_uncertainty = output.coverage_factor * u;
    output.first_order.standard_uncertainty = 1.06 * u;
    output.monte_carlo = normal_trials(estimate, u);
    result.outputs.push_back(std::move(output));
}

inline void add_contributions(UncertaintyResult& result) {
    constexpr int quantities = 16;
    for (int i = 0; i < quantities; ++i) {
        BudgetComponent component;
        component.quantities = {std::string(i % 2 ? "b_" : "p_") + std::to_string(i / 2 + 1) + "xyz"[i % 3]};
        component.id = component.quantities.front() + ".calibration";
        component.name = i == 1 ? "length standard" : "calibration of the artefact";
        if (i == 1) component.quantities = {"b_1x", "b_2x", "b_3x"};
        result.budget.components.push_back(component);
    }
    for (const OutputResult& output : result.outputs) {
        std::vector<BudgetRow> rows;
        double sum = 0.0;
        for (int i = 0; i < quantities; ++i) sum += std::pow(0.75, i);
        for (int i = 0; i < quantities; ++i) {
            BudgetRow row;
            row.component = static_cast<std::size_t>(i);
            row.share = std::pow(0.75, i) / sum;
            row.contribution = output.standard_uncertainty * std::sqrt(row.share);
            rows.push_back(row);
        }
        result.budget.rows.push_back(std::move(rows));
    }
}

inline void add_convergence(UncertaintyResult& result) {
    for (double trials = 1e4; trials <= plot_trials * 1.001; trials *= std::pow(10.0, 0.1)) {
        ConvergencePoint point;
        point.trials = static_cast<std::uint64_t>(std::llround(trials));
        for (const OutputResult& output : result.outputs) {
            const double wave = 0.8 * std::sin(3.0 * std::log(trials)) / std::sqrt(2.0 * trials);
            point.mean.push_back(output.estimate);
            point.standard_uncertainty.push_back(output.standard_uncertainty * (1.0 + wave));
        }
        result.convergence.push_back(std::move(point));
    }
}

/// x, y, z in mm, three angles in degrees; correlation of outputs i and j: (-0.8)^|i-j|.
inline UncertaintyResult plot_sample() {
    UncertaintyResult result;
    const double degree = std::acos(-1.0) / 180.0;
    add_output(result, "x", "mm", -0.12, 0.000367);
    add_output(result, "y", "mm", 0.12, 0.000313);
    add_output(result, "z", "mm", 1.174909, 0.00015);
    add_output(result, "alpha", "deg", 5.0 * degree, 0.0505 * degree);
    add_output(result, "beta", "deg", -5.0 * degree, 0.0505 * degree);
    add_output(result, "gamma_7", "deg", 0.0, 0.0505 * degree);
    const auto n = static_cast<Eigen::Index>(result.outputs.size());
    Eigen::MatrixXd covariance(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            covariance(i, j) = std::pow(-0.8, std::abs(i - j)) *
                               result.outputs[static_cast<std::size_t>(i)].standard_uncertainty *
                               result.outputs[static_cast<std::size_t>(j)].standard_uncertainty;
    result.covariance = std::move(covariance);
    result.trials = static_cast<std::uint64_t>(plot_trials);
    add_contributions(result);
    add_convergence(result);
    return result;
}

}  // namespace covaria::test
