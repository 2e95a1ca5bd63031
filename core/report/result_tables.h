// The tables of one analysis for CSV, one after the other.
#pragma once

#include <functional>

#include "core/report/report.h"

namespace covaria {

/// As `result_tables`, each given away before the next is made: of hundreds of points they take some hundred
/// megabytes together.
void each_result_table(const Project& project, const EvaluatedAnalysis& evaluated,
                       const std::function<void(DataTable)>& take);

}  // namespace covaria
