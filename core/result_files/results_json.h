// results.json: the contract of the command line for scripts (DESIGN 9).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/made/evaluated_analysis.h"

namespace covaria {

/// Failures and files that results.json lists beside the results of analyses.
struct ResultFile {
    std::string name;
    std::vector<std::pair<std::string, std::string>> of;  ///< "analysis": "a", "table": "budget", "group" ...
};
struct ResultListing {
    std::vector<FailedAnalysis> failed = {};
    std::vector<ResultFile> files = {};
    const MadeProject* made = nullptr;  ///< whose certificates are named with each result; null: none are
};

std::string results_json(const Project& project, const std::vector<EvaluatedAnalysis>& analyses,
                         const ResultListing& listing = {});

}  // namespace covaria
