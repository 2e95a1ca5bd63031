// Builds the report of a project's results, and writes it and the tables in text formats.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/made/made_project.h"
#include "core/report/report_document.h"
#include "core/result/comparison.h"
#include "core/result/design_result.h"
#include "core/result/study_result.h"
#include "core/result/uncertainty_result.h"
#include "core/text/document_language.h"

namespace covaria {

/// Earlier results of an analysis beside those of now.
struct ResultsBefore {
    Message words;  ///< where they come from: kept ones, another analysis, a file
    ResultComparison comparison;
};

struct EvaluatedAnalysis {
    std::shared_ptr<const PreparedAnalysis> analysis;
    std::shared_ptr<const UncertaintyResult> result;
    std::vector<Message> warnings = {};  ///< of its assets and of its model: `warnings_of`
    std::vector<std::shared_ptr<const StudyResult>> studies = {};
    std::vector<std::shared_ptr<const DesignResult>> designs = {};
    std::shared_ptr<const ResultsBefore> before = {};  ///< null: its report compares with nothing
};

/// Of these analyses, in their order.
std::vector<std::string> ids_of(const std::vector<EvaluatedAnalysis>& analyses);

/// An analysis of the project, or a study or design of one, that has no results.
struct FailedAnalysis {
    std::string id, name;
    std::string study = {};  ///< its id, where only the study or design failed
    Message cause;
};
/// What a report is made of.
struct ReportSource {
    const MadeProject& made;
    const std::vector<EvaluatedAnalysis>& analyses;
    const std::vector<FailedAnalysis>& failed;
    const DocumentLanguage& in = DocumentLanguage::english();  ///< outlives it
};
/// What stands beside the results of analyses in results.json.
struct ResultFile {
    std::string name;
    std::vector<std::pair<std::string, std::string>> of;  ///< "analysis": "a", "table": "budget", "group" ...
};
struct ResultListing {
    std::vector<FailedAnalysis> failed = {};
    std::vector<ResultFile> files = {};
};

/// Title block, model and references, inputs and origin, asset evaluations, budgets, results, distributions,
/// scene, correlation, notes, provenance; without the analyses and chapters that `contents` leave out.
ReportDocument build_report(const MadeProject& project, const std::vector<EvaluatedAnalysis>& analyses,
                            const std::vector<FailedAnalysis>& failed, const ReportContents& contents,
                            const DocumentLanguage& in = {});
/// With the contents that the project states.
ReportDocument build_report(const MadeProject& project, const std::vector<EvaluatedAnalysis>& analyses,
                            const std::vector<FailedAnalysis>& failed = {}, const DocumentLanguage& in = {});

/// Which of the evaluated analyses' results a certificate states.
enum class CertifiedResults {
    all,      ///< those analyses were chosen
    that_fit  ///< of a project with more than 60 results only analyses whose results fit; it says which not
};
/// A calibration certificate: the project's certificate section, result lines, conformity with its decision
/// rule, place for a signature. What is required and missing is a visible gap.
ReportDocument build_certificate(const MadeProject& project, const std::vector<EvaluatedAnalysis>& analyses,
                                 const std::vector<FailedAnalysis>& failed = {},
                                 CertifiedResults which = CertifiedResults::that_fit,
                                 const DocumentLanguage& in = {});

/// Ids of the analyses that report and certificate of a project are of, where none were chosen by hand.
std::vector<std::string> reported_analyses(const Project& project);

enum class DocumentKind { report, certificate };
/// Of those of the analyses that the project does not leave out; of all, where they were `chosen` by hand.
/// In that language.
ReportDocument build_document(DocumentKind kind, const MadeProject& project,
                              const std::vector<EvaluatedAnalysis>& analyses,
                              const std::vector<FailedAnalysis>& failed, bool chosen = false,
                              const DocumentLanguage& in = {});

/// Tables of one analysis for CSV: "results", "budget", "covariance", "correlation", "inputs", "regions" and,
/// with Monte Carlo, "histograms" and "convergence" (the ids); one for each study.
/// `project`: whose requirements are judged.
std::vector<Table> result_tables(const Project& project, const EvaluatedAnalysis& evaluated);
/// Of a study: one line per grid point, with the reason where it has no values. The id is "study-ID".
Table study_table(const StudyResult& study);
/// A study as people read it: axes as they were typed, what is looked at of the outputs, remarks where there
/// are any. Reads the study when it is asked for cells.
Table study_view(const StudyResult& study, const DocumentLanguage& in);
/// The evaluation of each asset; ids start with the asset's.
std::vector<Table> asset_tables(const AssetLibrary& assets);

std::string to_markdown(const ReportDocument& document);  ///< figures as "ID.png" / "ID.svg" beside the file
std::string to_html(const ReportDocument& document);      ///< one file; figures beside it as in Markdown
std::string html_body(const std::vector<ReportBlock>& blocks);  ///< what stands between <body> and </body>
/// RFC 4180, full precision, units in the heads.
std::string to_csv(const Table& table, const DisplayUnits& units = {});
std::string results_json(const Project& project, const std::vector<EvaluatedAnalysis>& analyses,
                         const ResultListing& listing = {});  ///< DESIGN 9

}  // namespace covaria
