#include "core/result/comparison.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace covaria {
namespace {

using Key = std::vector<std::string>;

Key key_of(const OutputQuantity& quantity) {
    return {quantity.group, quantity.symbol};
}

/// The budget of one output of a result.
class OutputBudget {
public:
    OutputBudget(const UncertaintyResult& result, std::size_t output)
        : components_(result.budget.components),
          rows_(output < result.budget.rows.size() ? &result.budget.rows[output] : nullptr),
          variance_(std::pow(result.outputs[output].first_order.standard_uncertainty, 2)) {}

    std::size_t size() const { return rows_ ? rows_->size() : 0; }
    double variance(std::size_t row) const { return (*rows_)[row].share * variance_; }
    Key id(std::size_t row) const { return {component(row).id}; }
    Key name(std::size_t row) const {
        Key key = component(row).quantities;
        key.push_back(component(row).name.english());
        return key;
    }

private:
    const BudgetComponent& component(std::size_t row) const { return components_[(*rows_)[row].component]; }

    const std::vector<BudgetComponent>& components_;
    const std::vector<BudgetRow>* rows_;
    double variance_;
};

/// Finds for each row after the row before.
class ComponentMatch {
public:
    ComponentMatch(const OutputBudget& before, const OutputBudget& after)
        : before_(before), after_(after), partner_(after.size()), taken_(before.size(), false) {}

    /// Pairs the rows that have no partner yet by a key; rows of equal keys in their order.
    void by(Key (OutputBudget::*key)(std::size_t) const) {
        std::map<Key, std::vector<std::size_t>> free;
        for (std::size_t row = before_.size(); row-- > 0;)
            if (!taken_[row]) free[(before_.*key)(row)].push_back(row);
        for (std::size_t row = 0; row < after_.size(); ++row) {
            if (partner_[row]) continue;
            const auto found = free.find((after_.*key)(row));
            if (found == free.end() || found->second.empty()) continue;
            partner_[row] = found->second.back();
            taken_[found->second.back()] = true;
            found->second.pop_back();
        }
    }

    std::vector<ComparedComponent> components() const {
        std::vector<ComparedComponent> all;
        for (std::size_t row = 0; row < after_.size(); ++row) {
            const double was = partner_[row] ? before_.variance(*partner_[row]) : 0.0;
            all.push_back({partner_[row], row, was, after_.variance(row)});
        }
        for (std::size_t row = 0; row < before_.size(); ++row)
            if (!taken_[row]) all.push_back({row, {}, before_.variance(row), 0.0});
        return all;
    }

private:
    const OutputBudget& before_;
    const OutputBudget& after_;
    std::vector<std::optional<std::size_t>> partner_;
    std::vector<bool> taken_;
};

}  // namespace

ResultComparison compare_results(ResultComparison::Pointer before, ResultComparison::Pointer after) {
    ResultComparison comparison{std::move(before), std::move(after), {}};
    const std::vector<OutputResult>& old = comparison.before->outputs;
    std::map<Key, std::size_t> place;
    for (std::size_t i = 0; i < old.size(); ++i) place.emplace(key_of(old[i].quantity), i);
    std::vector<bool> found(old.size(), false);
    for (std::size_t i = 0; i < comparison.after->outputs.size(); ++i) {
        const OutputQuantity& quantity = comparison.after->outputs[i].quantity;
        const auto it = place.find(key_of(quantity));
        const bool same =
            it != place.end() && old[it->second].quantity.unit.dimension() == quantity.unit.dimension();
        comparison.outputs.push_back({same ? std::optional(it->second) : std::nullopt, i});
        if (same) found[it->second] = true;
    }
    for (std::size_t i = 0; i < old.size(); ++i)
        if (!found[i]) comparison.outputs.push_back({i, {}});
    return comparison;
}

std::vector<ComparedComponent> compare_budgets(const ResultComparison& comparison,
                                               const ComparedOutput& output) {
    if (!output.in_both()) return {};
    const OutputBudget before(*comparison.before, *output.before);
    const OutputBudget after(*comparison.after, *output.after);
    ComponentMatch match(before, after);
    match.by(&OutputBudget::id);
    match.by(&OutputBudget::name);
    std::vector<ComparedComponent> all = match.components();
    std::stable_sort(all.begin(), all.end(), [](const ComparedComponent& a, const ComparedComponent& b) {
        return std::abs(a.change()) > std::abs(b.change());
    });
    return all;
}

std::optional<double> relative_change(double a, double b) {
    if (!(a > 0.0) || !std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
    return (b - a) / a;
}

}  // namespace covaria
