#include "core/design/candidate.h"

#include <algorithm>
#include <cmath>

#include "core/base/guarded.h"
#include "core/design/layout_constraints.h"
#include "core/propagation/evaluate_summary.h"

namespace covaria::detail {

namespace {

constexpr double without_model = 1e3;  ///< violation: worse than anything in space

Judged infeasible(const Message& reason, double violation = without_model) {
    Judged judged;
    judged.reason = reason.empty() ? tell<"the model cannot be evaluated">() : reason;
    judged.violation = violation;
    return judged;
}

}  // namespace

double objective_of(DesignObjective objective, const std::vector<double>& expanded,
                    const References& references) {
    double largest = 0.0, sum = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < expanded.size(); ++k) {
        const double ratio = expanded[k] / references[k];
        largest = std::max(largest, ratio);
        sum += ratio;
        squares += ratio * ratio;
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, expanded.size()));
    switch (objective) {
        case DesignObjective::mean:
            return sum / count;
        case DesignObjective::root_mean_square:
            return std::sqrt(squares / count);
        case DesignObjective::largest:
        case DesignObjective::cost:
            break;
    }
    return largest;
}

CandidateJudge::CandidateJudge(const PreparedDesign& design, References references)
    : design_(design),
      references_(std::move(references)),
      options_(design.numbers.analysis->options),
      in_space_(design.design.least_distance || !design.design.keep_out.empty() ||
                !design.design.hidden_by.empty()),
      changed_(design.numbers) {
    options_.method = Method::first_order;
    for (const DesignedOutput& output : design.outputs)
        indices_.push_back(find_output(design.numbers.analysis->model->outputs(), output.wanted, no_output));
}

Judged CandidateJudge::judge(const Candidate& candidate) {
    Judged worst = judge_one(candidate, Constraints::kept);
    const auto& variables = design_.design.variables;
    for (std::size_t i = 0; worst.feasible() && i < variables.size(); ++i)
        for (const double side : {-1.0, 1.0}) {
            if (variables[i].tolerance == 0.0) continue;
            Candidate moved = candidate;
            moved.values[i] += side * variables[i].tolerance;
            Judged judged = judge_one(moved, Constraints::kept);
            if (judged.merit() > worst.merit()) worst = std::move(judged);
        }
    return worst;
}

Judged CandidateJudge::result_of(const Candidate& candidate) {
    return judge_one(candidate, Constraints::ignored);
}

Judged CandidateJudge::judge_one(const Candidate& candidate, Constraints constraints) {
    auto judged = guarded([&]() -> Judged {
        const auto changed = model_of(candidate);
        if (!changed) return infeasible(changed.error().message);
        Judged of_model = judge_model(*changed, constraints);
        if (constraints == Constraints::kept && of_model.feasible()) price(candidate, of_model);
        return of_model;
    });
    return judged ? *std::move(judged) : infeasible(judged.error().message);
}

/// The objective is the largest ratio until here.
void CandidateJudge::price(const Candidate& candidate, Judged& judged) const {
    if (design_.design.objective != DesignObjective::cost || !design_.design.choose) return;
    if (judged.objective > 1.0) {
        judged.violation = judged.objective - 1.0;
        judged.reason = tell<"a target uncertainty is not met">();
    }
    judged.objective = design_.design.choose->price_of(candidate.rows);
}

// Values first: their targets are rows of the whole table.
Result<ChangedModel> CandidateJudge::model_of(const Candidate& candidate) {
    if (!design_.table) {
        changed_.set(candidate.values);
        return changed_.make();
    }
    const DesignTable& table = *design_.table;
    Project& project = changed_.project();
    Setup& setup = table.asset == StudyTarget::analysis ? project.analyses.front().setup
                                                        : project.assets[table.asset].setup;
    auto& rows = std::get<SetupTable>(setup.values.at(table.key)).rows;
    rows = table.rows.rows;
    changed_.set(candidate.values);
    for (std::size_t i = 0; i < candidate.rows.size(); ++i)
        if (candidate.rows[i] != i) rows[i] = std::move(rows[candidate.rows[i]]);
    rows.resize(candidate.rows.size());
    std::vector<std::size_t> assets = design_.assets_without_rows;
    for (const std::size_t row : candidate.rows)
        assets.insert(assets.end(), design_.assets_of_rows[row].begin(), design_.assets_of_rows[row].end());
    std::sort(assets.begin(), assets.end());
    assets.erase(std::unique(assets.begin(), assets.end()), assets.end());
    return changed_.make_with(assets);
}

Judged CandidateJudge::judge_model(const ChangedModel& changed, Constraints constraints) const {
    const MeasurementModel& model = changed.model();
    if (in_space_ && constraints == Constraints::kept) {
        const LayoutVerdict verdict =
            judge_layout(model.layout(estimates_of(changed.inputs)), design_.design);
        if (!verdict.reason.empty()) return infeasible(verdict.reason, verdict.violation);
    }
    std::vector<std::size_t> indices;
    for (std::size_t k = 0; k < indices_.size(); ++k) {
        indices.push_back(find_output(model.outputs(), design_.outputs[k].wanted, indices_[k]));
        if (indices.back() == no_output)
            return infeasible(
                tell<"there is no output quantity '%1' then">(design_.outputs[k].wanted.symbol));
    }
    const auto summary =
        evaluate_summary(model, changed.inputs, indices, options_, [](std::uint64_t) { return true; });
    if (!summary) return infeasible(summary.error().message);
    Judged judged;
    judged.standard.assign(summary->standard_uncertainty.begin(), summary->standard_uncertainty.end());
    for (const double U : summary->expanded_uncertainty) {
        if (!std::isfinite(U)) return infeasible(tell<"an uncertainty has no finite value">());
        // Differences that cancel, as between directions that are equal; not a measurement without
        // uncertainty.
        if (!(U > 0.0)) return infeasible(tell<"an uncertainty vanishes: the model is degenerate there">());
        judged.expanded.push_back(U);
    }
    if (!references_.empty())
        judged.objective = objective_of(design_.design.objective, judged.expanded, references_);
    return judged;
}

}  // namespace covaria::detail
