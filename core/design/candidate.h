// Candidates of a design, one after the other, by one thread: their objective, or why they have none.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/design/design.h"

namespace covaria::detail {

struct Candidate {
    std::vector<double> values;     ///< values of the variables, in their units
    std::vector<std::size_t> rows;  ///< kept, rising; of no meaning without a table
};

struct Judged {
    double objective = std::numeric_limits<double>::infinity();
    std::vector<double> expanded = {};  ///< U of the outputs looked at
    std::vector<double> standard = {};  ///< u of the outputs looked at
    Message reason = {};                ///< why there is no result, or which constraint is violated
    double violation = 0.0;
    bool cancelled = false;

    bool feasible() const { return reason.empty() && !cancelled; }
    /// Figure that a search compares: infeasible ones are all worse, by how much they violate. Where the
    /// objective is the cost, those that do not meet the targets have `expanded` all the same.
    double merit() const { return feasible() ? objective : 1e30 * (1.0 + violation); }
};

/// Denominators of the ratios: target uncertainties, or U of the present design.
using References = std::vector<double>;
double objective_of(DesignObjective objective, const std::vector<double>& expanded,
                    const References& references);

class CandidateJudge {
public:
    CandidateJudge(const PreparedDesign& design, References references);

    /// The worst one over the tolerances of the variables.
    Judged judge(const Candidate& candidate);
    /// Without tolerances and constraints.
    Judged result_of(const Candidate& candidate);
    Result<ChangedModel> model_of(const Candidate& candidate);
    const References& references() const { return references_; }

private:
    enum class Constraints { kept, ignored };
    Judged judge_one(const Candidate& candidate, Constraints constraints);
    Judged judge_model(const ChangedModel& changed, Constraints constraints) const;
    void price(const Candidate& candidate, Judged& judged) const;

    const PreparedDesign& design_;
    References references_;
    EvaluationOptions options_;
    std::vector<std::size_t> indices_;  ///< indices of the outputs in the unchanged model
    bool in_space_;                     ///< there are constraints
    ChangedProject changed_;
};

}  // namespace covaria::detail
