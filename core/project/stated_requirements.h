// Requirements of an analysis as typed, checked and in SI.
#pragma once

#include <string>
#include <vector>

#include "core/model/output_quantity.h"
#include "core/project/project.h"
#include "core/propagation/requirements.h"
#include "core/text/document_language.h"

namespace covaria {

/// The decision rule of a guard factor by its name in ILAC-G8:09/2019: "simple acceptance (w = 0)", "guard
/// band w = U", "guard band w = 0.83 U"; a negative factor widens the tolerance.
std::string decision_rule(double guard_factor, const DocumentLanguage& in = {});
/// Likewise of any rule of guard bands: "NCSL RP-10 guard band".
std::string decision_rule(const OutputRequirement& requirement, const DocumentLanguage& in = {});

/// The verdicts on a result of the analysis by its requirements as they are now. What cannot be read is left
/// out: it is a problem of the project.
std::vector<RequirementResult> judge(const UncertaintyResult& result, const AnalysisEntry& entry);

/// Of the analysis with this id; none where the project has none of it.
std::vector<RequirementResult> judge(const UncertaintyResult& result, const Project& project,
                                     const std::string& analysis);

/// Problems: paths relative to the analysis ("/requirements/0/targetUncertainty").
std::vector<OutputRequirement> read_requirements(const AnalysisEntry& entry,
                                                 const std::vector<OutputQuantity>& outputs,
                                                 Problems& problems);

}  // namespace covaria
