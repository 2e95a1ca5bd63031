#include "core/propagation/reverse_budget.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/propagation/engine_parts.h"
#include "core/propagation/order_statistics.h"
#include "core/propagation/parallel_blocks.h"
#include "core/propagation/trial_block_runner.h"

namespace covaria {

namespace {

using namespace detail;

constexpr std::size_t most_components = 12;
constexpr std::uint64_t most_trials = 100'000, least_trials = 10'000;
constexpr double most_draws = 1e8;  ///< draws of one evaluation

/// U of an output when one component, or all, are multiplied by a factor.
class VariedUncertainty {
public:
    virtual ~VariedUncertainty() = default;
    virtual Result<double> of_component(std::size_t component, double factor) = 0;
    virtual Result<double> of_all(double factor) = 0;
    virtual double tolerance() const = 0;  ///< relative, of the U found
    virtual int steps() const = 0;         ///< looked at from 1 down to 0: U need not fall all the way
};

/// y = sum of c_i epsilon_i: the law of propagation once more, with the sensitivities that are known.
class LinearForm final : public MeasurementModel {
public:
    LinearForm(const UncertaintyResult& result, std::size_t output,
               const std::vector<ComponentCorrelation>& correlations)
        : outputs_{result.outputs[output].quantity} {
        std::vector<std::size_t> place(result.inputs->components.size(), InputSet::npos);
        for (const BudgetRow& row : result.budget.rows[output]) {
            const bool is_rest = result.budget.components[row.component].is_rest;
            const std::size_t added = inputs_.add(
                is_rest ? UncertaintyComponent{.distribution = Distribution::normal(row.contribution)}
                        : result.inputs->components[row.component]);
            if (!is_rest) place[row.component] = added;
            row_.push_back({inputs_.quantities.size(), row.sensitivity});
            inputs_.quantities.push_back({.symbol = {}, .name = {}, .shares = {{added, 1.0}}});
        }
        for (const VarianceEstimate& estimate : result.inputs->variance_estimates)
            for (const std::size_t c : estimate.components)
                if (place[c] != InputSet::npos) inputs_.rest_on_estimate(estimate.id, place[c]);
        for (const ComponentCorrelation& r : correlations)
            if (place[r.first] != InputSet::npos && place[r.second] != InputSet::npos)
                inputs_.correlations.push_back({place[r.first], place[r.second], r.coefficient});
    }
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    bool evaluate(std::span<const double>, std::span<double> y) const override {
        y[0] = 0.0;
        return true;
    }
    bool sensitivities(std::span<const double>, SensitivityRows& rows) const override {
        rows = {row_};
        return true;
    }
    Layout layout(std::span<const double>) const override { return {}; }

private:
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    std::vector<Sensitivity> row_;
};

class ByLawOfPropagation final : public VariedUncertainty {
public:
    ByLawOfPropagation(const UncertaintyResult& result, std::size_t output,
                       const std::vector<ComponentCorrelation>& correlations)
        : result_(result), output_(output), form_(result, output, correlations) {}

    Result<double> of_component(std::size_t component, double factor) override {
        InputSet inputs = form_.inputs();
        const auto& rows = result_.budget.rows[output_];
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i].component == component) scale_component(inputs, i, factor);
        return expanded(inputs);
    }
    Result<double> of_all(double factor) override {
        return factor * result_.outputs[output_].expanded_uncertainty;  // nu_eff stays
    }
    double tolerance() const override { return 1e-12; }
    int steps() const override { return 32; }

private:
    Result<double> expanded(const InputSet& inputs) const {
        const auto law = law_of_propagation(form_, inputs, inputs.correlations);
        if (!law) return fail(law.error());
        const double k = result_.fixed_coverage_factor.value_or(
            coverage_factor_of(result_.coverage_probability, law->degrees_of_freedom(0)));
        return law->uncertainty(0) > 0.0 ? k * law->uncertainty(0) : 0.0;
    }

    const UncertaintyResult& result_;
    std::size_t output_;
    LinearForm form_;
};

/// The same draws each time, so that U follows the factor without scatter.
class ByMonteCarlo final : public VariedUncertainty {
public:
    ByMonteCarlo(const MeasurementModel& model, const UncertaintyResult& result, std::size_t output,
                 const std::vector<ComponentCorrelation>& correlations, const RunControl& control)
        : model_(model),
          result_(result),
          output_(output),
          correlations_(correlations),
          quiet_{control.stop, {}, control.threads} {
        const double draws = static_cast<double>(result.inputs->components.size() + 1);
        trials_ = std::min({result.trials, most_trials,
                            std::max(least_trials, static_cast<std::uint64_t>(most_draws / draws))});
    }
    std::uint64_t trials() const { return trials_; }

    Result<double> of_component(std::size_t component, double factor) override {
        InputSet inputs = result_.inputs;
        scale_component(inputs, component, factor);
        return relative(inputs);
    }
    Result<double> of_all(double factor) override {
        InputSet inputs = result_.inputs;
        for (InputQuantity& quantity : inputs.quantities)
            for (Share& share : quantity.shares) scale_share(inputs, quantity, share, factor);
        return relative(inputs);
    }
    double tolerance() const override { return 1e-4; }
    int steps() const override { return 1; }

private:
    /// U of the whole run times what the change makes of it in these trials.
    Result<double> relative(const InputSet& inputs) {
        if (unchanged_ == 0.0) {
            const auto expanded_now = expanded(result_.inputs);
            if (!expanded_now) return expanded_now;
            unchanged_ = *expanded_now;
        }
        const auto changed = expanded(inputs);
        if (!changed || !(unchanged_ > 0.0)) return changed;
        return result_.outputs[output_].expanded_uncertainty * (*changed / unchanged_);
    }

    Result<double> expanded(const InputSet& inputs) const {
        const DrawPlan plan(inputs, correlations_);
        TrialSource source{&model_, &plan, result_.provenance.seed, {}};
        source.estimate.resize(static_cast<Eigen::Index>(result_.outputs.size()));
        for (std::size_t j = 0; j < result_.outputs.size(); ++j)
            source.estimate(static_cast<Eigen::Index>(j)) = result_.outputs[j].first_order.estimate;
        std::vector<std::vector<double>> units((trials_ + unit_trials - 1) / unit_trials);
        RunMonitor monitor(quiet_, 0);
        const WorkEnd end = run_each(units.size(), monitor, [&](std::uint64_t unit) {
            TrialBlockRunner runner(source);
            const std::uint64_t last = std::min((unit + 1) * unit_trials, trials_);
            for (std::uint64_t t = unit * unit_trials; t < last; t += block_trials) {
                runner.run(t, static_cast<std::size_t>(std::min<std::uint64_t>(block_trials, last - t)));
                const double* y = runner.output(output_);
                units[unit].insert(units[unit].end(), y, y + runner.valid());
            }
        });
        if (end == WorkEnd::cancelled)
            return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
        std::vector<double> values;
        for (const auto& unit : units) values.insert(values.end(), unit.begin(), unit.end());
        if (values.size() < 2) return fail(ErrorCode::numeric, tell<"no trial has a value">());
        return result_.fixed_coverage_factor ? *result_.fixed_coverage_factor * standard_deviation(values)
                                             : half_interval(values);
    }

    double half_interval(std::vector<double>& values) const {
        const CoverageRanks ranks = coverage_ranks(values.size(), result_.coverage_probability);
        const auto value_at = [&](std::uint64_t rank) {
            const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
            std::nth_element(values.begin(), place, values.end());
            return *place;
        };
        const double low = value_at(ranks.r), high = value_at(ranks.r + ranks.q);
        return 0.5 * (high - low);
    }

    static double standard_deviation(const std::vector<double>& values) {
        const double first = values.front(), n = static_cast<double>(values.size());
        double sum = 0.0, squares = 0.0;
        for (const double y : values) {
            sum += y - first;
            squares += (y - first) * (y - first);
        }
        return std::sqrt(std::max(0.0, (squares - sum * sum / n) / (n - 1.0)));
    }

    const MeasurementModel& model_;
    const UncertaintyResult& result_;
    std::size_t output_;
    const std::vector<ComponentCorrelation>& correlations_;
    RunControl quiet_;
    std::uint64_t trials_ = 0;
    double unchanged_ = 0.0;
};

/// A factor with U at or just below the target, nearest to 1. U^2 is almost linear in factor^2.
class FactorSearch {
public:
    using Expanded = std::function<Result<double>(double)>;
    FactorSearch(Expanded expanded, double now, double target, double tolerance)
        : expanded_(std::move(expanded)), target_(target), tolerance_(tolerance), high_{1.0, now} {}

    /// Empty: U does not come down to the target.
    Result<std::optional<double>> find(int steps) {
        for (int i = steps - 1; i >= 0; --i) {
            const double factor = static_cast<double>(i) / steps;
            const auto U = expanded_(factor);
            if (!U) return fail(U.error());
            if (*U <= target_) {
                low_ = {factor, *U};
                return narrowed();
            }
            high_ = {factor, *U};
        }
        return std::optional<double>();
    }

private:
    struct Point {
        double factor = 0.0, U = 0.0;
    };

    Result<std::optional<double>> narrowed() {
        const double aim = target_ * (1.0 - 0.5 * tolerance_);
        double weight_low = 1.0, weight_high = 1.0;  // Illinois: an end that stays counts half
        for (int step = 0; step < 100 && low_.U < target_ * (1.0 - tolerance_); ++step) {
            const double a = low_.factor * low_.factor, b = high_.factor * high_.factor;
            const double below = weight_low * (aim * aim - low_.U * low_.U);
            const double above = weight_high * (high_.U * high_.U - aim * aim);
            if (!(below > 0.0) || !(b - a > 1e-15 * b)) break;
            const double factor = std::sqrt(a + (b - a) * below / (below + above));
            const auto U = expanded_(factor);
            if (!U) return fail(U.error());
            const bool is_low = *U <= target_;
            (is_low ? low_ : high_) = {factor, *U};
            weight_low = is_low ? 1.0 : 0.5 * weight_low;
            weight_high = is_low ? 0.5 * weight_high : 1.0;
        }
        return std::optional<double>(low_.factor);
    }

    Expanded expanded_;
    double target_, tolerance_;
    Point low_, high_;
};

Result<ReverseBudget> searched(VariedUncertainty& varied, const UncertaintyResult& result, std::size_t output,
                               double target) {
    ReverseBudget made;
    const double now = result.outputs[output].expanded_uncertainty;
    bool any = false;
    for (const BudgetRow& row : result.budget.rows[output]) {
        const BudgetComponent& component = result.budget.components[row.component];
        if (made.reductions.size() == most_components) break;
        if (!(row.contribution > 0.0) || component.held || component.is_rest) continue;
        FactorSearch search([&](double factor) { return varied.of_component(row.component, factor); }, now,
                            target, varied.tolerance());
        const auto factor = search.find(varied.steps());
        if (!factor) return fail(factor.error());
        made.reductions.push_back({row.component, component.standard_uncertainty, std::nullopt});
        if (*factor) made.reductions.back().needed = **factor * component.standard_uncertainty;
        if (*factor &&
            varied.steps() > 1) {  // a single step has begun with none of it, at or below the target
            const auto vanished = varied.of_component(row.component, 0.0);
            if (!vanished) return fail(vanished.error());
            made.reductions.back().rises_again = *vanished > target;
        }
        any = any || factor->has_value();
    }
    if (any) return made;
    FactorSearch search([&](double factor) { return varied.of_all(factor); }, now, target,
                        varied.tolerance());
    const auto factor = search.find(1);
    if (!factor) return fail(factor.error());
    made.common_factor = *factor;
    return made;
}

}  // namespace

std::optional<double> ReverseBudget::Reduction::factor() const {
    return needed ? std::optional<double>(*needed / now) : std::nullopt;
}

void scale_share(const InputSet& inputs, InputQuantity& quantity, Share& share, double factor) {
    quantity.offset += (1.0 - factor) * share.factor * inputs.components[share.component].distribution.mean();
    share.factor *= factor;
}

void scale_component(InputSet& inputs, std::size_t component, double factor) {
    for (InputQuantity& quantity : inputs.quantities)
        for (Share& share : quantity.shares)
            if (share.component == component) scale_share(inputs, quantity, share, factor);
}

Result<ReverseBudget> reverse_budget(const MeasurementModel* model, const UncertaintyResult& result,
                                     std::size_t output, double target, const RunControl& control) {
    const double now = result.outputs[output].expanded_uncertainty;
    if (!(now > target) || !std::isfinite(now)) return ReverseBudget{};
    const auto correlations = resolved_correlations(result.inputs);
    if (!correlations) return fail(correlations.error());
    if (result.trials == 0) {
        ByLawOfPropagation law(result, output, *correlations);
        return searched(law, result, output, target);
    }
    if (!model) return ReverseBudget{};
    ByMonteCarlo trials(*model, result, output, *correlations, control);
    auto made = searched(trials, result, output, target);
    if (made) made->trials = trials.trials();
    return made;
}

}  // namespace covaria
