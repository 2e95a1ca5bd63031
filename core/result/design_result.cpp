#include "core/result/design_result.h"

#include <algorithm>

namespace covaria {

bool DesignValue::is_at_end() const {
    const double near = 1e-6 * (to - from);
    return chosen - from <= near || (!cost && to - chosen <= near);
}

bool DesignGoal::met() const {
    if (!target) return true;
    if (!(after <= *target)) return false;
    return !validated || *validated || !monte_carlo || *monte_carlo <= *target;
}

bool DesignResult::met() const {
    return found && std::all_of(goals.begin(), goals.end(), [](const auto& goal) { return goal.met(); });
}

bool stands_in_space(const DesignResult& design) {
    if (!design.found) return false;
    return !design.places.tracks.empty() ||
           std::any_of(design.gains.begin(), design.gains.end(),
                       [](const DesignGain& gain) { return gain.place.has_value(); });
}

}  // namespace covaria
