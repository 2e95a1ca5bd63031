// The result lines of many runs as one table.
#pragma once

#include <string>

#include "app/evaluation.h"

namespace covaria {

/// Head of the table: name, analysis, group, symbol, unit, estimate, u, U, k, p, low, high, met.
std::string result_lines_head();
/// A line for every measurand of an evaluated project, in the units of its outputs; "met" is of the
/// requirement on it.
std::string result_lines(const std::string& name, const Project& project,
                         const std::vector<EvaluatedAnalysis>& analyses);

}  // namespace covaria
