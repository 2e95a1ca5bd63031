// A design from the present state to the verified best.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/guarded.h"
#include "core/design/cost_search.h"
#include "core/design/design_space.h"
#include "core/design/layout_constraints.h"
#include "core/design/reduction_search.h"
#include "core/design/row_search.h"
#include "core/design/value_search.h"
#include "core/project/design_fields.h"
#include "core/propagation/engine.h"

namespace covaria {

namespace {

using namespace detail;

constexpr double least_gain_of_source = 1e-3;  ///< least gain that is stated
constexpr std::size_t most_sources = 20;

Candidate present_candidate(const PreparedDesign& design) {
    Candidate present{design.present, {}};
    if (design.table)
        for (std::size_t row = 0; row < design.table->present; ++row) present.rows.push_back(row);
    return present;
}

bool is_priced(const PreparedDesign& design) {
    return design.table && design.design.objective == DesignObjective::cost;
}

/// Statements about the chosen design: its values and rows, what each of them gains, its verification.
class ChosenDesign {
public:
    ChosenDesign(const PreparedDesign& design, const RunControl& control, const Candidate& chosen,
                 DesignResult& result)
        : design_(design), control_(control), chosen_(chosen), result_(result) {}

    void state(SearchBook& book, const References& references) {
        for (const auto& [words, reason] : book.notes().reasons) result_.reasons.push_back(reason);
        std::stable_sort(result_.reasons.begin(), result_.reasons.end(),
                         [](const auto& a, const auto& b) { return a.count > b.count; });
        if (design_.design.reductions.empty()) result_.path = book.notes().steps;
        state_values();
        if (!result_.found) {
            result_.evaluations = book.notes().evaluations;
            return;
        }
        const auto judge = book.judges().lend();
        const Judged chosen = judge->judge(chosen_);
        result_.objective = objective_of(design_.design.objective, chosen.expanded, references);
        const Judged nominal = judge->result_of(chosen_);
        for (std::size_t k = 0; k < references.size(); ++k) result_.goals[k].after = nominal.expanded[k];
        DesignSpace space(*judge, design_, chosen_, control_.stop);
        if (design_.table) state_rows(book, references, space.places_of_rows());
        result_.places = space.places(result_.path);
        result_.evaluations = book.notes().evaluations;
        verify(*judge, references);
    }

private:
    void state_values() {
        const Design& design = design_.design;
        for (std::size_t i = 0; i < design_.numbers.axes.size(); ++i) {
            const StudyAxis& axis = design_.numbers.axes[i];
            const TypesetMessage title = changed_title(design_.numbers.targets[i], axis.change);
            result_.values.push_back(
                {title, axis.unit, axis.from, axis.to, design_.present[i], chosen_.values[i], 0.0, {}});
            if (i < design.variables.size()) result_.values.back().tolerance = design.variables[i].tolerance;
            if (i < design.reductions.size())
                result_.values.back().cost = cost_of(design.reductions[i], chosen_.values[i]);
        }
    }

    /// Candidates with each row that was kept left out, and with each other one added.
    std::vector<Candidate> with_one_row_changed() const {
        std::vector<Candidate> candidates;
        for (std::size_t row = 0; row < design_.table->rows.rows.size(); ++row) {
            Candidate changed = chosen_;
            const auto at = std::lower_bound(changed.rows.begin(), changed.rows.end(), row);
            if (at != changed.rows.end() && *at == row)
                changed.rows.erase(at);
            else
                changed.rows.insert(at, row);
            candidates.push_back(std::move(changed));
        }
        return candidates;
    }

    void state_rows(SearchBook& book, const References& references,
                    const std::vector<std::optional<Eigen::Vector3d>>& places) {
        const auto& fixed = design_.design.choose->fixed;
        const std::vector<Judged> changed = book.judge_all(with_one_row_changed(), "one row more or less");
        for (std::size_t row = 0; row < changed.size(); ++row) {
            const bool kept = std::binary_search(chosen_.rows.begin(), chosen_.rows.end(), row);
            std::optional<double> other;
            if (!changed[row].expanded.empty())
                other = objective_of(design_.design.objective, changed[row].expanded, references);
            result_.gains.push_back({row, name_of_row(row), kept, {}, places[row]});
            if (other)
                result_.gains.back().gain =
                    kept ? 1.0 - result_.objective / *other : 1.0 - *other / result_.objective;
            if (!kept) continue;
            result_.rows.push_back({row, name_of_row(row),
                                    std::find(fixed.begin(), fixed.end(), row) != fixed.end(),
                                    row >= design_.table->present, other});
            if (is_priced(design_)) result_.rows.back().price = design_.design.choose->price_of({row});
        }
    }

    /// Name of a row, with its number, from 1, where others are called the same.
    Message name_of_row(std::size_t row) const {
        const SetupTable& table = design_.table->rows;
        const Message words = row_words(table, row);
        for (std::size_t other = 0; other < table.rows.size(); ++other)
            if (other != row && row_words(table, other) == words) return tell<"%1 (row %2)">(words, row + 1);
        return words;
    }

    /// States sources by the shares of variance in the budget. A statement of an asset is one; components
    /// that are typed by themselves are one each.
    void state_sources(const UncertaintyResult& verified, const InputSet& inputs,
                       const References& references) {
        std::set<std::string> of_assets;  // ids
        for (const UncertaintyComponent& component : inputs.components)
            if (!component.contributor.empty() && !component.origin.empty()) of_assets.insert(component.id);
        struct Shares {
            Message origin;
            std::vector<double> of_goals;
        };
        std::map<std::string, Shares> shares;  // by the English words
        std::vector<double> expanded;
        for (std::size_t k = 0; k < result_.goals.size(); ++k) {
            expanded.push_back(result_.goals[k].after);
            const std::size_t j = output_of(verified, result_.goals[k]);
            if (j == verified.outputs.size() || j >= verified.budget.rows.size()) return;
            for (const BudgetRow& row : verified.budget.rows[j]) {
                const BudgetComponent& component = verified.budget.components[row.component];
                const Message origin = component.is_rest                  ? component.name
                                       : of_assets.contains(component.id) ? component.origin
                                                                          : Message(component.id);
                Shares& made = shares[origin.english()];
                made.origin = origin;
                made.of_goals.resize(result_.goals.size(), 0.0);
                made.of_goals[k] += row.share;
            }
        }
        const double now = objective_of(design_.design.objective, expanded, references);
        for (const auto& [words, share] : shares) {
            std::vector<double> without = expanded;
            for (std::size_t k = 0; k < without.size(); ++k)
                without[k] *= std::sqrt(std::max(0.0, 1.0 - share.of_goals[k]));
            const double gain = 1.0 - objective_of(design_.design.objective, without, references) / now;
            if (gain > least_gain_of_source) result_.sources.push_back({share.origin, gain});
        }
        std::stable_sort(result_.sources.begin(), result_.sources.end(),
                         [](const DesignSource& a, const DesignSource& b) { return a.gain > b.gain; });
        if (result_.sources.size() > most_sources) result_.sources.resize(most_sources);
    }

    static std::size_t output_of(const UncertaintyResult& result, const DesignGoal& goal) {
        const auto found = std::find_if(result.outputs.begin(), result.outputs.end(), [&](const auto& one) {
            return one.quantity.symbol == goal.output.symbol && one.quantity.group == goal.output.group;
        });
        return static_cast<std::size_t>(found - result.outputs.begin());
    }

    void verify(CandidateJudge& judge, const References& references) {
        EvaluationOptions options = design_.numbers.analysis->options;
        options.method = Method::monte_carlo;
        if (design_.design.trials > 0) options.trials = design_.design.trials;
        options.contributor_trials = options.one_at_a_time_trials = options.sobol_trials = 0;
        const auto changed = judge.model_of(chosen_);
        const auto verified = changed ? evaluate(changed->model(), changed->inputs, options,
                                                 {control_.stop, {}, control_.threads})
                                      : Result<UncertaintyResult>(fail(changed.error()));
        if (!verified && verified.error().code == ErrorCode::cancelled) throw Stopped{};
        if (!verified) {
            result_.not_verified = verified.error().message;
            return;
        }
        result_.trials = verified->trials;
        result_.failed_trials = verified->failed_trials;
        for (DesignGoal& goal : result_.goals) {
            const std::size_t j = output_of(*verified, goal);
            if (j == verified->outputs.size()) continue;
            const OutputResult& output = verified->outputs[j];
            goal.monte_carlo = output.expanded_uncertainty;
            const auto& validation = output.first_order.validation;
            if (!validation) continue;
            goal.validated = validation->validated;
            goal.is_close = validation->is_close;
        }
        state_sources(*verified, changed->inputs, references);
    }

    const PreparedDesign& design_;
    const RunControl& control_;
    const Candidate& chosen_;
    DesignResult& result_;
};

class DesignRun {
public:
    DesignRun(const PreparedDesign& design, const RunControl& control)
        : design_(design), control_(control), chosen_(present_candidate(design)) {}

    Result<DesignResult> run() {
        describe();
        const auto references = look_at_present();
        if (!references) return fail(references.error());
        if (auto possible = check_constraints(); !possible) return fail(possible.error());
        SearchBook book(design_, *references, control_);
        judge_present(book, *references);
        if (!design_.design.reductions.empty()) {
            if (auto reduced = reduce(book); !reduced) return fail(reduced.error());
        } else if (is_priced(design_)) {
            if (auto chosen = choose_cheapest(book); !chosen) return fail(chosen.error());
        } else {
            search(book);
        }
        ChosenDesign(design_, control_, chosen_, result_).state(book, *references);
        return std::move(result_);
    }

private:
    bool has_targets() const {
        return std::all_of(design_.outputs.begin(), design_.outputs.end(),
                           [](const DesignedOutput& output) { return output.target.has_value(); });
    }

    void describe() {
        const Design& design = design_.design;
        result_.id = design.id;
        result_.name = design.name.empty() ? design.id : design.name;
        result_.analysis = design_.numbers.analysis->id;
        result_.objective_words = objective_words(design.objective, has_targets());
        result_.candidates = design_.table ? design_.table->rows.rows.size() : 0;
        result_.seed = design.seed;
        result_.coverage_probability = design_.numbers.analysis->options.coverage_probability;
        result_.fingerprint = design_.fingerprint;
        for (const DesignedOutput& output : design_.outputs) {
            DesignGoal goal;
            goal.output = output.quantity;
            goal.target = output.target;
            result_.goals.push_back(std::move(goal));
        }
    }

    /// U now, whether the constraints allow it or not; and what U is looked at relative to.
    Result<References> look_at_present() {
        const Judged now = CandidateJudge(design_, {}).result_of(chosen_);
        for (std::size_t k = 0; k < now.expanded.size(); ++k) result_.goals[k].before = now.expanded[k];
        if (design_.outputs.empty())
            return fail(ErrorCode::bad_input,
                        tell<"the analysis has no measurand that a design could look at">());
        References references;
        for (std::size_t k = 0; k < design_.outputs.size(); ++k) {
            const auto& target = design_.outputs[k].target;
            if (!target && now.expanded.empty())
                return fail(ErrorCode::bad_input,
                            tell<"without target uncertainties U is looked at relative to that of the "
                                 "present design, which has no result (%1): state requirements">(now.reason));
            references.push_back(target ? *target : now.expanded[k]);
            if (!(references.back() > 0.0))
                return fail(ErrorCode::bad_input,
                            tell<"U of '%1' is zero now: choose the outputs to look at">(
                                design_.outputs[k].quantity.symbol));
        }
        return references;
    }

    Result<void> check_constraints() const {
        const PreparedAnalysis& analysis = *design_.numbers.analysis;
        const Message objection =
            why_not_judged(analysis.model->layout(estimates_of(analysis.inputs)), design_.design);
        if (objection.empty()) return {};
        return fail(ErrorCode::bad_input, objection);
    }

    /// Judges the present design; where it may not be as it is, without constraints and tolerances.
    void judge_present(SearchBook& book, const References& references) {
        std::vector<double> expanded;
        for (const DesignGoal& goal : result_.goals)
            if (goal.before) expanded.push_back(*goal.before);
        if (expanded.size() == references.size())
            result_.before = objective_of(design_.design.objective, expanded, references);
        const Judged now = book.judges().lend()->judge(chosen_);
        result_.why_not_before = now.reason;
        if (!now.expanded.empty()) {
            result_.why_not_before = {};
            result_.before = objective_of(design_.design.objective, now.expanded, references);
        }
    }

    Result<void> reduce(SearchBook& book) {
        for (const DesignedOutput& output : design_.outputs)
            if (!output.target)
                return fail(ErrorCode::bad_input,
                            tell<"the cheapest reductions need target uncertainties: state requirements">());
        const auto found = find_reductions(book);
        if (!found) return fail(found.error());
        result_.found = true;
        chosen_.values = found->factors;
        result_.cost = found->cost;
        result_.front = found->front;
        for (std::size_t k = 0; k < result_.goals.size(); ++k)
            if (found->prices[k] > 0.0) result_.goals[k].price_of_target = found->prices[k];
        return {};
    }

    Result<void> choose_cheapest(SearchBook& book) {
        if (!has_targets())
            return fail(ErrorCode::bad_input,
                        tell<"the cheapest rows need target uncertainties: state requirements">());
        CostSearch::Found found = CostSearch(book, chosen_.values).find();
        chosen_.rows = std::move(found.rows);
        result_.found = found.has_result;
        result_.proved = found.proved;
        result_.cost = design_.design.choose->price_of(chosen_.rows);
        result_.front = std::move(found.front);
        return {};
    }

    void search(SearchBook& book) {
        result_.found = true;
        if (design_.table) {
            RowSearch rows(book, chosen_.values);
            const RowSearch::Found found = rows.find();
            chosen_.rows = found.rows;
            result_.found = found.feasible;
            result_.proved = found.proved && design_.design.variables.empty();
            if (found.feasible && design_.design.variables.empty()) result_.curve = rows.curve(found.rows);
        }
        if (!design_.design.variables.empty()) {
            const FoundValues found = find_values(book, chosen_.rows, chosen_.values);
            chosen_.values = found.values;
            result_.found = found.feasible;
            if (!design_.table || !found.feasible) return;
            alternate(book);
            // The curve is for the values that were found: the searches before looked at rows at others.
            result_.curve = RowSearch(book, chosen_.values).curve(chosen_.rows);
        }
    }

    /// Rows with the values found, values with the rows found, as long as other rows gain. Both searches
    /// begin where the other ended, so that it never becomes worse.
    void alternate(SearchBook& book) {
        constexpr int most_turns = 10;
        for (int turn = 0; turn < most_turns && book.left() > 0; ++turn) {
            RowSearch rows(book, chosen_.values);
            const RowSearch::Found better = rows.improve(chosen_.rows);
            if (!better.feasible || better.rows == chosen_.rows) return;
            chosen_.rows = better.rows;
            const FoundValues found = find_values(book, chosen_.rows, std::vector<double>(chosen_.values));
            if (found.feasible) chosen_.values = found.values;
        }
    }

    const PreparedDesign& design_;
    const RunControl& control_;
    Candidate chosen_;
    DesignResult result_;
};

}  // namespace

Result<DesignResult> run_design(const PreparedDesign& design, const RunControl& control) {
    try {
        return DesignRun(design, control).run();
    } catch (const Stopped&) {
        return fail(ErrorCode::cancelled, tell<"the design was stopped">());
    }
}

}  // namespace covaria
