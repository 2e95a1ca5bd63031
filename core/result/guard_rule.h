// Rules by which the guard band of a tolerance is chosen.
#pragma once

namespace covaria {

/// L is half of the tolerance, TUR = L/U, w the guard band.
enum class GuardRule {
    factor,         ///< w = r U (ISO 14253-1, ILAC-G8)
    rss,            ///< root of the sum of squares: L - w = sqrt(L^2 - U^2)
    rp10,           ///< NCSL RP-10: L - w = L (1.25 - 1/TUR), below a TUR of 4
    dobbert,        ///< managed guard band: w = U (1.04 - exp(0.38 ln TUR - 0.54)), at most 2 % false accepts
    specific_risk,  ///< a result at the acceptance limit has the target risk not to conform
    global_risk,    ///< the global consumer's risk is the target, for the prior
    accepted_risk,  ///< the part of what is accepted that does not conform is the target, for the prior
};

/// Needs both limits of a tolerance.
inline bool is_of_ratio(GuardRule rule) {
    return rule == GuardRule::rss || rule == GuardRule::rp10 || rule == GuardRule::dobbert;
}
/// Needs a prior.
inline bool is_of_prior(GuardRule rule) {
    return rule == GuardRule::global_risk || rule == GuardRule::accepted_risk;
}
/// Is made for a target risk.
inline bool has_target_risk(GuardRule rule) {
    return rule == GuardRule::specific_risk || is_of_prior(rule);
}

}  // namespace covaria
