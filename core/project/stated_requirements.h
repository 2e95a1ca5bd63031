// Requirements of an analysis as they were typed, checked and in SI.
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
/// The decision rule of a requirement with any rule of guard bands: "NCSL RP-10 guard band".
std::string decision_rule(const OutputRequirement& requirement, const DocumentLanguage& in = {});

/// The verdicts on a result of the analysis by its requirements as they are now. Requirements that cannot be
/// read are left out: they are a problem of the project.
std::vector<RequirementResult> judge(const UncertaintyResult& result, const AnalysisEntry& entry);

/// The verdicts by the requirements of the analysis with this id; none where the project has no such
/// analysis.
std::vector<RequirementResult> judge(const UncertaintyResult& result, const Project& project,
                                     const std::string& analysis);

/// The requirements of an analysis. Problems have paths relative to the analysis
/// ("/requirements/0/targetUncertainty").
std::vector<OutputRequirement> read_requirements(const AnalysisEntry& entry,
                                                 const std::vector<OutputQuantity>& outputs,
                                                 Problems& problems);

}  // namespace covaria
