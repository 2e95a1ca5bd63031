// The tables of one analysis as CSV files, one after the other.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/made/evaluated_analysis.h"
#include "core/text/table.h"

namespace covaria {

/// Tables of one analysis for CSV: "results", "budget", "covariance", "correlation", "inputs", "regions" and,
/// with Monte Carlo, "histograms" and "convergence" (the ids); one for each study.
/// `project`: whose requirements are judged.
std::vector<Table> result_tables(const Project& project, const EvaluatedAnalysis& evaluated);
/// A study as a file: one line per grid point, with the reason where it has no values. The id is "study-ID".
Table study_table(const StudyResult& study);
/// The evaluation of each asset; ids start with the asset's.
std::vector<Table> asset_tables(const AssetLibrary& assets);

/// take(id, CSV) of each of `result_tables`, made and given away before the next: of hundreds of points they
/// take some gigabytes together.
void each_result_file(const Project& project, const EvaluatedAnalysis& evaluated,
                      const std::function<void(const std::string&, const std::string&)>& take);

}  // namespace covaria
