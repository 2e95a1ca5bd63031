// The results that belong to the project as it is now.
#pragma once

#include <vector>

#include "core/report/report.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui {

/// Of the analyses that are up to date, in the project's order.
std::vector<EvaluatedAnalysis> current_results(const Project& project, const AnalysisRunner& runner);

}  // namespace covaria::ui
