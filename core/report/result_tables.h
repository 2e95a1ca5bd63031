// The tables of one analysis as CSV files, one after the other.
#pragma once

#include <functional>
#include <string>

#include "core/report/report.h"

namespace covaria {

/// take(id, CSV) of each of `result_tables`, made and given away before the next: of hundreds of points they
/// take some gigabytes together.
void each_result_file(const Project& project, const EvaluatedAnalysis& evaluated,
                      const std::function<void(const std::string&, const std::string&)>& take);

}  // namespace covaria
