// The uncertainty that a laboratory may state for a result: never below its best capability (ILAC-P14).
#pragma once

#include <optional>
#include <vector>

#include "core/made/evaluated_analysis.h"

namespace covaria {

enum class CapabilityVerdict {
    raised,   ///< U is smaller than the best capability, which is stated in its place
    refused,  ///< U is smaller, and the laboratory does not state it
    outside,  ///< the laboratory has no capability for the result
};

/// A result of which the evaluated U may not be stated.
struct CapabilityFinding {
    std::size_t output = 0;
    CapabilityVerdict verdict = CapabilityVerdict::outside;
    double smallest = 0.0;  ///< smallest U that may be stated (SI); nothing is known of it outside
    Message words = {};     ///< finding in words: "U of L, 31 nm, is below the capability of 50 nm (...)"
    Message for_customers = {};  ///< the same as a certificate says it
};

/// The finding for one output; none where its U may be stated, it is no measurand, or the project has no
/// capabilities.
std::optional<CapabilityFinding> capability_finding(const MadeProject& made, const UncertaintyResult& result,
                                                    std::size_t output);
/// Findings for all outputs of a result, in their order.
std::vector<CapabilityFinding> capability_findings(const MadeProject& made, const UncertaintyResult& result);

/// The analyses as a certificate states them: with every U that is raised, and without the results of which
/// the laboratory does not state U; these are no measurands any more.
std::vector<EvaluatedAnalysis> as_stated(const MadeProject& made, std::vector<EvaluatedAnalysis> analyses);

}  // namespace covaria
