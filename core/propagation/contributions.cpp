// Budget and one-at-a-time Monte Carlo.
#include "core/propagation/contributions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>

#include "core/propagation/condensed_law.h"
#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {
namespace {

std::vector<BudgetRow> rows_of(const LawOfPropagation& law, Eigen::Index output) {
    std::vector<BudgetRow> rows;
    const double variance = law.covariance(output, output);
    for (const PropagationTerm& term : law.terms[static_cast<std::size_t>(output)]) {
        if (term.sensitivity == 0.0) continue;
        BudgetRow row;
        row.component = term.component;
        row.sensitivity = term.sensitivity;
        row.contribution = std::abs(term.contribution);
        if (variance > 0) row.share = term.contribution * term.correlated / variance;
        rows.push_back(row);
    }
    sort_rows(rows);
    return rows;
}

/// Rows of an output that nothing influences to first order, with every c zero: Monte Carlo may show more.
/// With many components the budget would be long and say no more: it is empty.
std::vector<BudgetRow> rows_without_influence(std::size_t components) {
    constexpr std::size_t few = 24;
    std::vector<BudgetRow> rows;
    for (std::size_t i = 0; components <= few && i < components; ++i) rows.push_back({.component = i});
    return rows;
}

constexpr std::size_t most_components_one_by_one = 10'000;

}  // namespace

std::vector<BudgetComponent> budget_components(const InputSet& inputs) {
    std::vector<BudgetComponent> result;
    result.reserve(inputs.components.size());
    for (const UncertaintyComponent& c : inputs.components) {
        BudgetComponent b;
        b.id = c.id;
        b.name = c.name;
        b.origin = c.origin;
        b.owner = c.contributor_name;
        b.unit = c.unit;
        b.distribution = std::string(drawn_distribution(c).title());
        b.type = c.type;
        b.standard_uncertainty = c.distribution.standard_uncertainty();
        b.degrees_of_freedom = std::min(c.degrees_of_freedom, c.distribution.degrees_of_freedom());
        b.held = c.held;
        b.tags = c.tags;
        result.push_back(std::move(b));
    }
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) {
        const InputQuantity& quantity = inputs.quantities[i];
        for (const Share& share : quantity.shares) {
            BudgetComponent& b = result[share.component];
            if (b.quantities.empty()) {
                b.group = quantity.group;
                b.tags.insert(b.tags.end(), quantity.tags.begin(), quantity.tags.end());
                b.estimate = estimate_of(inputs, i);
                b.quantity_unit = quantity.unit;
            }
            b.quantities.push_back(quantity.symbol);
        }
    }
    return result;
}

void sort_rows(std::vector<BudgetRow>& rows) {
    std::stable_sort(rows.begin(), rows.end(), [](const BudgetRow& a, const BudgetRow& b) {
        return std::abs(a.share) > std::abs(b.share);
    });
}

std::vector<double> trial_uncertainties(const TrialSource& source, std::uint64_t trials, RunMonitor& monitor,
                                        std::uint64_t* failed) {
    TrialBlockRunner runner(source);
    const std::size_t m = source.outputs();
    std::vector<double> shift(m, 0.0), sum(m, 0.0), squares(m, 0.0), u(m, 0.0);
    std::uint64_t count = 0;
    for (std::uint64_t first = 0; first < trials; first += block_trials) {
        runner.run(first, std::min<std::uint64_t>(block_trials, trials - first));
        for (std::size_t j = 0; j < m; ++j) {
            const double* y = runner.output(j);
            if (count == 0 && runner.valid() > 0) shift[j] = y[0];
            for (std::size_t t = 0; t < runner.valid(); ++t) {
                sum[j] += y[t] - shift[j];
                squares[j] += (y[t] - shift[j]) * (y[t] - shift[j]);
            }
        }
        count += runner.valid();
        if (!monitor.advance(0)) return {};
    }
    const auto n = static_cast<double>(count);
    for (std::size_t j = 0; j < m && count > 1; ++j)
        u[j] = std::sqrt(std::max(0.0, (squares[j] - sum[j] * sum[j] / n) / (n - 1)));
    if (failed) *failed = trials - count;
    return u;
}

UncertaintyBudget budget_of(const InputSet& inputs, const LawOfPropagation& law) {
    if (law.condensed) return law.condensed->budget;
    const bool large = inputs.components.size() > most_components_one_by_one;
    UncertaintyBudget budget;
    std::future<std::vector<BudgetComponent>> components =
        std::async(large ? std::launch::async : std::launch::deferred, budget_components, std::cref(inputs));
    for (Eigen::Index j = 0; j < law.estimate.size(); ++j) {
        budget.rows.push_back(rows_of(law, j));
        const bool known = law.differentiable[static_cast<std::size_t>(j)];
        if (known && budget.rows.back().empty())
            budget.rows.back() = rows_without_influence(inputs.components.size());
    }
    budget.components = components.get();
    return budget;
}

Result<void> add_one_at_a_time(UncertaintyBudget& budget, const RunContext& context, const InputSet& inputs,
                               const Correlations& correlations, std::uint64_t trials) {
    std::vector<char> contributes(budget.components.size(), 0);
    for (const auto& rows : budget.rows)
        for (const BudgetRow& row : rows)
            if (row.share != 0.0) contributes[row.component] = 1;
    std::vector<std::vector<double>> u(budget.components.size());
    const WorkEnd end = run_each(inputs.components.size(), context.monitor, [&](std::uint64_t c) {
        if (contributes[c] == 0) return;
        const DrawPlan plan(inputs, correlations, static_cast<std::size_t>(c));
        TrialSource alone = context.source;
        alone.plan = &plan;
        u[c] = trial_uncertainties(alone, trials, context.monitor, nullptr);
    });
    if (end == WorkEnd::cancelled || context.monitor.stopped())
        return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    for (std::size_t j = 0; j < budget.rows.size(); ++j)
        for (BudgetRow& row : budget.rows[j])
            if (!u[row.component].empty()) row.one_at_a_time = u[row.component][j];
    return {};
}

}  // namespace covaria::detail
