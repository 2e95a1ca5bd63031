// Builds the report and the certificate of a project out of its results.
#pragma once

#include <string>
#include <vector>

#include "core/document/report_document.h"
#include "core/made/evaluated_analysis.h"
#include "core/project/report_contents.h"
#include "core/text/document_language.h"

namespace covaria {

/// The source of a report.
struct ReportSource {
    const MadeProject& made;
    const std::vector<EvaluatedAnalysis>& analyses;
    const std::vector<FailedAnalysis>& failed;
    const DocumentLanguage& in = DocumentLanguage::english();  ///< language, which outlives the source
};
/// The report of a project: title block, model and references, inputs and origin, asset evaluations, budgets,
/// results, distributions, scene, correlation, notes, provenance; without the analyses and chapters that
/// `contents` leave out.
ReportDocument build_report(const MadeProject& project, const std::vector<EvaluatedAnalysis>& analyses,
                            const std::vector<FailedAnalysis>& failed, const ReportContents& contents,
                            const DocumentLanguage& in = {});
/// The sheet, without the analyses and chapters that `contents` leave out.
ReportDocument build_sheet(const MadeProject& project, const std::vector<EvaluatedAnalysis>& analyses,
                           const std::vector<FailedAnalysis>& failed, const ReportContents& contents,
                           const DocumentLanguage& in = {});
/// The report with the contents that the project states.
ReportDocument build_report(const MadeProject& project, const std::vector<EvaluatedAnalysis>& analyses,
                            const std::vector<FailedAnalysis>& failed = {}, const DocumentLanguage& in = {});

/// The choice of the evaluated analyses whose results a certificate states.
enum class CertifiedResults {
    all,      ///< all of them, because those analyses were chosen
    that_fit  ///< of a project with more than 60 results the analyses whose results fit; it says which do not
};
/// A calibration certificate: the project's certificate section, result lines, conformity with its decision
/// rule, place for a signature. A text that is required and missing is a visible gap.
ReportDocument build_certificate(const MadeProject& project, const std::vector<EvaluatedAnalysis>& analyses,
                                 const std::vector<FailedAnalysis>& failed = {},
                                 CertifiedResults which = CertifiedResults::that_fit,
                                 const DocumentLanguage& in = {});

/// Ids of the analyses that report and certificate of a project are of, where none were chosen by hand.
std::vector<std::string> reported_analyses(const Project& project);

/// A sheet is a report of two pages for each analysis: of tests their decisions, of others the results and
/// the budget, then what there is room for.
enum class DocumentKind { report, certificate, sheet };
/// The document, in that language, of those of the analyses that the project does not leave out; of all of
/// them, where they were `chosen` by hand.
ReportDocument build_document(DocumentKind kind, const MadeProject& project,
                              const std::vector<EvaluatedAnalysis>& analyses,
                              const std::vector<FailedAnalysis>& failed, bool chosen = false,
                              const DocumentLanguage& in = {});

}  // namespace covaria
