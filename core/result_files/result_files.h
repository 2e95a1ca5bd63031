// The files that a run leaves: results.json, a table each as CSV, and what else is listed with them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/made/evaluated_analysis.h"
#include "core/result_files/results_json.h"

namespace covaria {

/// results.json, which lists all other files, and the tables of analyses, studies and assets. `others` are
/// written by the caller (pictures).
Result<void> write_result_files(const std::filesystem::path& folder, const MadeProject& made,
                                const std::vector<EvaluatedAnalysis>& analyses, ResultListing listing = {});

}  // namespace covaria
