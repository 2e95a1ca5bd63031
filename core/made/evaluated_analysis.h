// An analysis with its results: what reports, files of results and writers are made of.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/made/made_project.h"
#include "core/result/comparison.h"
#include "core/result/design_result.h"
#include "core/result/study_result.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

/// Earlier results of an analysis beside those of now.
struct ResultsBefore {
    Message words;  ///< source: kept results, another analysis, a file
    ResultComparison comparison;
};

struct EvaluatedAnalysis {
    std::shared_ptr<const PreparedAnalysis> analysis;
    std::shared_ptr<const UncertaintyResult> result;
    std::vector<Message> warnings = {};  ///< warnings of its assets and of its model: `warnings_of`
    std::vector<std::shared_ptr<const StudyResult>> studies = {};
    std::vector<std::shared_ptr<const DesignResult>> designs = {};
    std::shared_ptr<const ResultsBefore> before = {};  ///< null: its report compares with nothing
};

/// Ids of these analyses, in their order.
std::vector<std::string> ids_of(const std::vector<EvaluatedAnalysis>& analyses);

/// An analysis of the project, or a study or design of one, that has no results.
struct FailedAnalysis {
    std::string id, name;
    std::string study = {};  ///< its id, where only the study or design failed
    Message cause;
};
}  // namespace covaria
