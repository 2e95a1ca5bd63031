// Result line of an output: which U it states, its interval, its coverage factor.
#pragma once

#include <string>

#include "core/result/uncertainty_result.h"

namespace covaria {

/// Source of the expanded uncertainty of a result.
enum class ExpandedBy {
    degrees_of_freedom,  ///< law of propagation: U = k_p(nu_eff) u (JCGM 100 G.4)
    interval,            ///< Monte Carlo: half the width of the symmetric coverage interval, k = U/u
    fixed_factor,        ///< U = k u with the k that the user fixed, either method
};
ExpandedBy expanded_by(const UncertaintyResult& result);
/// Key of that source for scripts: "effective-degrees-of-freedom", "half-interval", "fixed-factor".
std::string expanded_key(const UncertaintyResult& result);
/// The same as a sentence: "U is half the width of the ... coverage interval, k = U/u."
Message expanded_words(const UncertaintyResult& result);
/// Whether U comes from trials in which components with finite degrees of freedom were drawn normal, by
/// choice: its k is not that of a t distribution for nu_eff (JCGM 100 G.6.4).
bool leaves_out_degrees_of_freedom(const UncertaintyResult& result);

/// Fills in U and k of the result line from its u, its interval (Monte Carlo) or nu_eff. k is NaN where it
/// has no meaning: u infinite (a Student t with at most two degrees of freedom in Monte Carlo).
void state_expanded_uncertainty(OutputResult& output, const UncertaintyResult& result);

/// The coverage interval of the result line, of the stated probability: the probabilistically symmetric one
/// of Monte Carlo, else y -+ k_p(nu_eff) u. Half of its width is U unless k was fixed.
CoverageInterval coverage_interval_of(const OutputResult& output, const UncertaintyResult& result);

/// "trials", "student-t", "normal": by what a probability of conformance was computed.
std::string distribution_key(RequirementResult::Distribution distribution);

/// Expanded uncertainty with everything of a contributor held (or of it alone): by Monte Carlo with the
/// coverage factor of the result line; by the law of propagation the part of U that u has, so that it
/// compares with a U of Monte Carlo.
double expanded_with(const OutputResult& output, const ContributorResult::Uncertainties& part,
                     std::size_t index);

}  // namespace covaria
