// A design from the present state to the verified best.
#include <algorithm>
#include <cmath>

#include "core/base/guarded.h"
#include "core/design/layout_constraints.h"
#include "core/design/reduction_search.h"
#include "core/design/row_search.h"
#include "core/design/value_search.h"
#include "core/propagation/engine.h"

namespace covaria {

namespace {

using namespace detail;

const char* words_of(DesignObjective objective, bool targets) {
    switch (objective) {
        case DesignObjective::mean:
            return targets ? "mean U/target" : "mean U relative to the present design";
        case DesignObjective::root_mean_square:
            return targets ? "root mean square of U/target"
                           : "root mean square of U relative to the present design";
        case DesignObjective::largest:
            break;
    }
    return targets ? "largest U/target" : "largest U relative to the present design";
}

Candidate present_candidate(const PreparedDesign& design) {
    Candidate present{design.present, {}};
    if (design.table)
        for (std::size_t row = 0; row < design.table->present; ++row) present.rows.push_back(row);
    return present;
}

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
        } else {
            search(book);
        }
        finish(book, *references);
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
        result_.objective_words = words_of(design.objective, has_targets());
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
            return fail(ErrorCode::bad_input, "the analysis has no measurand that a design could look at");
        References references;
        for (std::size_t k = 0; k < design_.outputs.size(); ++k) {
            const auto& target = design_.outputs[k].target;
            if (!target && now.expanded.empty())
                return fail(ErrorCode::bad_input,
                            "without target uncertainties U is looked at relative to that of the present "
                            "design, which has no result (" +
                                now.reason + "): state requirements");
            references.push_back(target ? *target : now.expanded[k]);
            if (!(references.back() > 0.0))
                return fail(ErrorCode::bad_input, "U of '" + design_.outputs[k].quantity.symbol +
                                                      "' is zero now: choose the outputs to look at");
        }
        return references;
    }

    Result<void> check_constraints() const {
        const PreparedAnalysis& analysis = *design_.numbers.analysis;
        const std::string objection =
            why_not_judged(analysis.model->layout(estimates_of(analysis.inputs)), design_.design);
        if (objection.empty()) return {};
        return fail(ErrorCode::bad_input, objection);
    }

    /// Where it may not be as it is, its objective is without constraints and tolerances.
    void judge_present(SearchBook& book, const References& references) {
        std::vector<double> expanded;
        for (const DesignGoal& goal : result_.goals)
            if (goal.before) expanded.push_back(*goal.before);
        if (expanded.size() == references.size())
            result_.before = objective_of(design_.design.objective, expanded, references);
        const Judged now = book.judges().lend()->judge(chosen_);
        result_.why_not_before = now.reason;
        if (now.feasible()) result_.before = now.objective;
    }

    Result<void> reduce(SearchBook& book) {
        for (const DesignedOutput& output : design_.outputs)
            if (!output.target)
                return fail(ErrorCode::bad_input,
                            "the cheapest reductions need target uncertainties: state requirements");
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

    void search(SearchBook& book) {
        result_.found = true;
        if (design_.table) {
            RowSearch rows(book, chosen_.values);
            const RowSearch::Found found = rows.find();
            chosen_.rows = found.rows;
            result_.found = found.feasible;
            result_.proved = found.proved && design_.design.variables.empty();
            if (found.feasible) result_.curve = rows.curve(found.rows);
        }
        if (!design_.design.variables.empty()) {
            const FoundValues found = find_values(book, chosen_.rows, chosen_.values);
            chosen_.values = found.values;
            result_.found = found.feasible;
            if (design_.table && found.feasible) alternate(book);
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

    void finish(SearchBook& book, const References& references) {
        for (const auto& [reason, count] : book.notes().reasons) result_.reasons.push_back({reason, count});
        std::stable_sort(result_.reasons.begin(), result_.reasons.end(),
                         [](const auto& a, const auto& b) { return a.count > b.count; });
        if (design_.design.reductions.empty()) result_.path = book.notes().steps;
        state_values();
        if (!result_.found) {
            result_.evaluations = book.notes().evaluations;
            return;
        }
        const auto judge = book.judges().lend();
        result_.objective = judge->judge(chosen_).objective;
        const Judged nominal = judge->result_of(chosen_);
        for (std::size_t k = 0; k < references.size(); ++k) result_.goals[k].after = nominal.expanded[k];
        if (design_.table) state_rows(book);
        result_.evaluations = book.notes().evaluations;
        verify(*judge);
    }

    void state_values() {
        const Design& design = design_.design;
        for (std::size_t i = 0; i < design_.numbers.axes.size(); ++i) {
            const StudyAxis& axis = design_.numbers.axes[i];
            Text title = design_.numbers.targets[i].title;
            if (axis.change == StudyChange::factor) title += ", factor";
            if (axis.change == StudyChange::added) title += ", added";
            result_.values.push_back(
                {title, axis.unit, axis.from, axis.to, design_.present[i], chosen_.values[i], 0.0, {}});
            if (i < design.variables.size()) result_.values.back().tolerance = design.variables[i].tolerance;
            if (i < design.reductions.size())
                result_.values.back().cost = cost_of(design.reductions[i], chosen_.values[i]);
        }
    }

    void state_rows(SearchBook& book) {
        RowSearch rows(book, chosen_.values);
        const auto without = rows.without_each(chosen_.rows);
        const auto& fixed = design_.design.choose->fixed;
        for (std::size_t i = 0; i < chosen_.rows.size(); ++i) {
            const std::size_t row = chosen_.rows[i];
            result_.rows.push_back({row, name_of_row(row),
                                    std::find(fixed.begin(), fixed.end(), row) != fixed.end(),
                                    row >= design_.table->present, without[i]});
        }
    }

    /// With its number, from 1, where others are called the same.
    std::string name_of_row(std::size_t row) const {
        const SetupTable& table = design_.table->rows;
        const std::string words = row_words(table, row);
        for (std::size_t other = 0; other < table.rows.size(); ++other)
            if (other != row && row_words(table, other) == words)
                return words + " (row " + std::to_string(row + 1) + ")";
        return words;
    }

    void verify(CandidateJudge& judge) {
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
        for (DesignGoal& goal : result_.goals)
            for (const OutputResult& output : verified->outputs) {
                if (output.quantity.symbol != goal.output.symbol ||
                    output.quantity.group != goal.output.group)
                    continue;
                goal.monte_carlo = output.expanded_uncertainty;
                if (output.first_order.validation) goal.validated = output.first_order.validation->validated;
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
        return fail(ErrorCode::cancelled, "the design was stopped");
    }
}

}  // namespace covaria
