#include "core/propagation/sobol.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/propagation/condensed_law.h"
#include "core/propagation/parallel_blocks.h"
#include "core/quantity/component_pairs.h"

namespace covaria::detail {
namespace {

std::string joined_ids(const InputSet& inputs, const std::vector<std::size_t>& components) {
    std::string text;
    for (std::size_t k = 0; k < components.size(); ++k) {
        if (k == 3 && components.size() > 4)
            return text + " and " + std::to_string(components.size() - 3) + " more";
        text += (k == 0 ? "" : ", ") + inputs.components[components[k]].id;
    }
    return text;
}

std::vector<std::vector<std::size_t>> joint_sets(const InputSet& inputs, const Correlations& correlations) {
    auto sets = dependent_sets(inputs, correlations);
    std::vector<bool> known(inputs.components.size(), false);
    for (const auto& set : sets)
        for (const std::size_t c : set) known[c] = true;
    for (std::size_t c = 0; c < known.size(); ++c)
        if (!known[c]) sets.push_back({c});
    return sets;
}

/// Largest share of each component in the budgets of a condensed law, by component; zero: it is in none.
std::vector<double> condensed_weights(const LawOfPropagation& law) {
    std::vector<double> weights;
    if (!law.condensed) return weights;
    weights.resize(law.condensed->budget.components.size(), 0.0);
    for (const std::vector<BudgetRow>& rows : law.condensed->budget.rows)
        for (const BudgetRow& row : rows)
            weights[row.component] = std::max(weights[row.component], std::abs(row.share));
    return weights;
}

/// Largest share of the variance of any output, by first order.
double weight_of(const std::vector<std::size_t>& set, const LawOfPropagation& law) {
    double weight = 0.0;
    for (std::size_t j = 0; j < law.terms.size(); ++j) {
        double squares = 0.0;
        for (const PropagationTerm& term : law.terms[j])
            if (std::find(set.begin(), set.end(), term.component) != set.end())
                squares += term.contribution * term.contribution;
        const auto row = static_cast<Eigen::Index>(j);
        if (law.covariance(row, row) > 0.0) weight = std::max(weight, squares / law.covariance(row, row));
    }
    return weight;
}

InputSet with_only(InputSet inputs, const SobolFactor& factor, bool inside) {
    std::vector<bool> member(inputs.components.size(), false);
    for (const std::size_t c : factor.components) member[c] = true;
    for (std::size_t c = 0; c < member.size(); ++c)
        inputs.components[c].held = inputs.components[c].held || member[c] != inside;
    return inputs;
}

/// Rows of outputs of one block with the model's flags; angles on the branch of the estimate.
class BlockOutputs {
public:
    BlockOutputs(const TrialSource& source)
        : source_(source), rows_(source.outputs()), flags_(block_trials) {}

    void evaluate(const TrialRows& inputs, std::size_t count) {
        std::fill(flags_.begin(), flags_.end(), std::uint8_t{1});
        source_.model->evaluate_block({inputs.data(), rows_.data(), flags_.data(), block_trials, count});
        for (std::size_t j = 0; j < source_.outputs(); ++j) {
            double* y = rows_.row(j);
            const double centre = source_.estimate(static_cast<Eigen::Index>(j));
            const bool periodic = source_.model->outputs()[j].periodic;
            constexpr double turn = 2.0 * std::numbers::pi;
            for (std::size_t t = 0; t < count; ++t) {
                if (!std::isfinite(y[t])) flags_[t] = 0;
                if (periodic) y[t] -= turn * std::nearbyint((y[t] - centre) / turn);
                y[t] -= centre;  // products of deviations lose no digits
            }
        }
    }
    const double* row(std::size_t j) const { return rows_.row(j); }
    bool valid(std::size_t t) const { return flags_[t] != 0; }

private:
    const TrialSource& source_;
    TrialRows rows_;
    std::vector<std::uint8_t> flags_;
};

/// Sums over the trials of one output: what the indices are means of, and its square, trial by trial.
class Sums {
public:
    /// y of trial a, of trial b, of trial a with the factor of b; about the estimate.
    void add(double y_a, double y_b, double y_ab) {
        const Eigen::Vector4d terms(y_b * (y_ab - y_a), 0.5 * (y_a - y_ab) * (y_a - y_ab),
                                    0.5 * (y_a * y_a + y_b * y_b), 0.5 * (y_a + y_b));
        n_ += 1.0;
        sum_ += terms;
        products_ += terms * terms.transpose();
    }

    SobolIndex index(const SobolFactor& factor) const {
        SobolIndex made{factor.name, factor.components};
        const Eigen::Vector4d mean = sum_ / n_;
        const double variance = mean[2] - mean[3] * mean[3];
        if (!(n_ > 1.0) || !(variance > 0.0)) return made;
        const Eigen::Matrix4d covariance = products_ / n_ - mean * mean.transpose();
        // An index is a ratio, and its denominator is estimated from the same trials.
        const auto error = [&](int numerator, double value) {
            Eigen::Vector4d slope(0.0, 0.0, -value, 2.0 * value * mean[3]);
            slope[numerator] = 1.0;
            return std::sqrt(std::max(0.0, slope.dot(covariance * slope)) / n_) / variance;
        };
        made.first = mean[0] / variance;
        made.total = mean[1] / variance;
        made.first_standard_error = error(0, made.first);
        made.total_standard_error = error(1, made.total);
        return made;
    }

private:
    double n_ = 0.0;
    Eigen::Vector4d sum_ = Eigen::Vector4d::Zero();  ///< first, total, mean square, mean
    Eigen::Matrix4d products_ = Eigen::Matrix4d::Zero();
};

/// Run for one factor: trials a, trials b, and trials a with the factor of b.
class FactorRun {
public:
    FactorRun(const TrialSource& source, const InputSet& inputs, const Correlations& correlations,
              const SobolFactor& factor)
        : source_(source),
          others_(with_only(inputs, factor, false), correlations),
          alone_(with_only(inputs, factor, true), correlations),
          x_a_(inputs.quantities.size()),
          x_b_(inputs.quantities.size()),
          part_(inputs.quantities.size()),
          workspace_(std::max({source.plan->latent_rows(), others_.latent_rows(), alone_.latent_rows()})),
          y_a_(source),
          y_b_(source),
          y_ab_(source),
          sums_(source.outputs()) {
        for (std::size_t i = 0; i < inputs.quantities.size(); ++i) means_.push_back(estimate_of(inputs, i));
    }

    void block(std::uint64_t first, std::uint64_t first_b, std::size_t count) {
        source_.plan->draw(source_.seed, first, count, x_a_, workspace_);
        y_a_.evaluate(x_a_, count);
        source_.plan->draw(source_.seed, first_b, count, x_b_, workspace_);
        y_b_.evaluate(x_b_, count);
        // Quantities are linear in components: x = x(others) + x(factor) - x(all at their means).
        others_.draw(source_.seed, first, count, x_a_, workspace_);
        alone_.draw(source_.seed, first_b, count, part_, workspace_);
        for (std::size_t i = 0; i < means_.size(); ++i)
            for (std::size_t t = 0; t < padded_to_lanes(count); ++t)
                x_a_.row(i)[t] += part_.row(i)[t] - means_[i];
        y_ab_.evaluate(x_a_, count);
        for (std::size_t j = 0; j < sums_.size(); ++j)
            for (std::size_t t = 0; t < count; ++t)
                if (y_a_.valid(t) && y_b_.valid(t) && y_ab_.valid(t))
                    sums_[j].add(y_a_.row(j)[t], y_b_.row(j)[t], y_ab_.row(j)[t]);
    }
    const std::vector<Sums>& sums() const { return sums_; }

private:
    const TrialSource& source_;
    DrawPlan others_, alone_;
    TrialRows x_a_, x_b_, part_;
    DrawWorkspace workspace_;
    BlockOutputs y_a_, y_b_, y_ab_;
    std::vector<Sums> sums_;
    std::vector<double> means_;
};

}  // namespace

std::vector<SobolFactor> sobol_factors(const InputSet& inputs, const LawOfPropagation& law,
                                       const Correlations& correlations, std::size_t most) {
    const std::vector<double> known = condensed_weights(law);
    std::vector<std::pair<double, std::vector<std::size_t>>> weighted;
    for (std::vector<std::size_t>& set : joint_sets(inputs, correlations)) {
        // A share of zero at the estimates need not be zero elsewhere: whatever varies counts.
        std::erase_if(set, [&](std::size_t c) { return !(law.u(static_cast<Eigen::Index>(c)) > 0.0); });
        if (set.empty()) continue;
        double weight = 0.0;
        for (const std::size_t c : law.condensed ? set : std::vector<std::size_t>())
            weight = std::max(weight, known[c]);
        weighted.emplace_back(law.condensed ? weight : weight_of(set, law), std::move(set));
    }
    std::stable_sort(weighted.begin(), weighted.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<SobolFactor> factors;
    for (auto& [weight, set] : weighted) {
        if (factors.size() < most)
            factors.push_back({joined_ids(inputs, set), std::move(set)});
        else
            factors.back().components.insert(factors.back().components.end(), set.begin(), set.end());
    }
    if (weighted.size() > most)
        factors.back().name = std::to_string(weighted.size() - most + 1) + " further factors together";
    return factors;
}

Result<std::vector<std::vector<SobolIndex>>> sobol_indices(const RunContext& context, const InputSet& inputs,
                                                           const Correlations& correlations,
                                                           const std::vector<SobolFactor>& factors,
                                                           std::uint64_t trials) {
    const std::size_t outputs = context.source.outputs();
    std::vector<std::vector<SobolIndex>> indices(outputs, std::vector<SobolIndex>(factors.size()));
    // The second set of trials begins at a block of its own.
    const std::uint64_t second = (trials + block_trials - 1) / block_trials * block_trials;
    const WorkEnd end = run_each(factors.size(), context.monitor, [&](std::uint64_t f) {
        FactorRun run(context.source, inputs, correlations, factors[f]);
        for (std::uint64_t first = 0; first < trials; first += block_trials) {
            run.block(first, second + first,
                      static_cast<std::size_t>(std::min<std::uint64_t>(block_trials, trials - first)));
            if (!context.monitor.advance(0)) return;
        }
        for (std::size_t j = 0; j < outputs; ++j) indices[j][f] = run.sums()[j].index(factors[f]);
    });
    if (end == WorkEnd::cancelled || context.monitor.stopped())
        return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    for (auto& of_output : indices)
        std::stable_sort(of_output.begin(), of_output.end(),
                         [](const SobolIndex& a, const SobolIndex& b) { return a.total > b.total; });
    return indices;
}

void add_rows_of_interactions(UncertaintyBudget& budget,
                              const std::vector<std::vector<SobolIndex>>& indices) {
    for (std::size_t j = 0; j < indices.size(); ++j)
        for (const SobolIndex& index : indices[j]) {
            if (!(index.total > least_total_index)) continue;
            std::vector<BudgetRow>& rows = budget.rows[j];
            for (const std::size_t component : index.components)
                if (std::none_of(rows.begin(), rows.end(),
                                 [&](const BudgetRow& row) { return row.component == component; }))
                    rows.push_back({.component = component});
        }
}

}  // namespace covaria::detail
