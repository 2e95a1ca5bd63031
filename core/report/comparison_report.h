// The document about results beside each other: `covaria compare`.
#pragma once

#include <string>
#include <vector>

#include "core/document/report_document.h"
#include "core/result/comparison.h"
#include "core/text/document_language.h"

namespace covaria {

struct ComparedAnalysis {
    std::string id;     ///< id that may stand in a file's name
    std::string title;  ///< title such as "pose", "pose beside network"
    ResultComparison comparison;
};
/// The two sides of a comparison in words.
struct ComparedSides {
    std::string before, after;                         ///< names of a file, or of what was changed in it
    std::vector<std::string> only_before, only_after;  ///< analyses without a counterpart
};

/// The document of a comparison: measurands with U beside U, then the changed components of the budgets that
/// changed most.
ReportDocument build_comparison(const ComparedSides& sides, const std::vector<ComparedAnalysis>& analyses,
                                const DocumentLanguage& in = {});

/// The tables of one analysis with everything in them, for CSV: "ID-compared-results" and
/// "ID-compared-budget".
std::vector<Table> comparison_tables(const ComparedAnalysis& analysis);

}  // namespace covaria
