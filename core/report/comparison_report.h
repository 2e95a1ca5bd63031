// What is written down about results beside each other: `covaria compare`.
#pragma once

#include <string>
#include <vector>

#include "core/document/report_document.h"
#include "core/result/comparison.h"
#include "core/text/document_language.h"

namespace covaria {

struct ComparedAnalysis {
    std::string id;     ///< file-name friendly
    std::string title;  ///< "pose", "pose beside network"
    ResultComparison comparison;
};
/// What is compared, in words.
struct ComparedSides {
    std::string before, after;                         ///< a file, or what was changed in it
    std::vector<std::string> only_before, only_after;  ///< analyses without a counterpart
};

/// Measurands with U beside U, then the changed components of the budgets that changed most.
ReportDocument build_comparison(const ComparedSides& sides, const std::vector<ComparedAnalysis>& analyses,
                                const DocumentLanguage& in = {});

/// Everything of one analysis for CSV: "ID-compared-results" and "ID-compared-budget".
std::vector<Table> comparison_tables(const ComparedAnalysis& analysis);

}  // namespace covaria
