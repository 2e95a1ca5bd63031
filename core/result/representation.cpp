#include "core/result/representation.h"

namespace covaria {

Message why_not_judged() {
    return tell<"the result does not represent the measurand: more than 1 % of the trials have no value">();
}

std::vector<std::size_t> not_representing(const StudyResult& study) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < study.points.size(); ++i)
        if (study.points[i].has_values() &&
            !represents_measurand(study.trials, study.points[i].failed_trials))
            found.push_back(i);
    return found;
}

Message remark_on(const StudyResult& study, std::size_t point) {
    const StudyPoint& at = study.points[point];
    if (!at.has_values()) return study.reasons[at.reason];
    if (represents_measurand(study.trials, at.failed_trials)) return {};
    return why_not_judged();
}

}  // namespace covaria
