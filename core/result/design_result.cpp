#include "core/result/design_result.h"

#include <algorithm>

namespace covaria {

bool DesignGoal::met() const {
    if (!target) return true;
    if (!(after <= *target)) return false;
    return !validated || *validated || !monte_carlo || *monte_carlo <= *target;
}

bool DesignResult::met() const {
    return found && std::all_of(goals.begin(), goals.end(), [](const auto& goal) { return goal.met(); });
}

}  // namespace covaria
