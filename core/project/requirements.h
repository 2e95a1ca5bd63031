// Requirements of an analysis as typed, checked and in SI.
#pragma once

#include <vector>

#include "core/model/output_quantity.h"
#include "core/project/project.h"
#include "core/propagation/requirements.h"

namespace covaria {

/// Problems: paths relative to the analysis ("/requirements/0/targetUncertainty").
std::vector<OutputRequirement> read_requirements(const AnalysisEntry& entry,
                                                 const std::vector<OutputQuantity>& outputs,
                                                 Problems& problems);

}  // namespace covaria
