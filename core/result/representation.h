// Check whether a result of Monte Carlo still says what the measurand may be: trials without a value are no
// random choice, so that with more than one in a hundred of them what is left is biased.
#pragma once

#include <string>
#include <vector>

#include "core/result/study_result.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

inline constexpr const char* does_not_represent = "does not represent the measurand";

constexpr bool represents_measurand(std::uint64_t trials, std::uint64_t failed_trials) {
    return 100 * failed_trials <= trials;
}
inline bool represents_measurand(const UncertaintyResult& result) {
    return represents_measurand(result.trials, result.failed_trials);
}

/// Words about requirements on such a result: "the result does not represent the measurand: ...".
Message why_not_judged();

/// Points of a study that have values, of too few trials.
std::vector<std::size_t> not_representing(const StudyResult& study);
/// Remark on a point of a study: why it has no values, or that they are of too few trials.
Message remark_on(const StudyResult& study, std::size_t point);

}  // namespace covaria
