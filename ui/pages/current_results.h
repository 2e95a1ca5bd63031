// The results of a project that may be reported and exported, and what is to be said of the rest.
#pragma once

#include <QString>
#include <vector>

#include "core/report/report.h"
#include "ui/export/report_maker.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui {

/// Analyses (in the order of the project) and studies whose results are those of the project as it is now,
/// with all the trials that it asks for.
std::vector<EvaluatedAnalysis> current_results(const Project& project, const AnalysisRunner& runner);
/// Analyses and studies of the project that failed, with the cause: what results.json lists beside the
/// results.
std::vector<FailedAnalysis> failed_results(const Project& project, const AnalysisRunner& runner);
/// Results that a document of the project is made from, with the failed ones. A certificate, which has
/// no list of what is missing in it, also gets the analyses that are not up to date.
ReportMaker::Source document_source(DocumentKind kind, const Project& project, const AnalysisRunner& runner);
/// Names of those analyses that are not among them.
QStringList left_out(const Project& project, const std::vector<std::string>& analyses,
                     const AnalysisRunner& runner);

}  // namespace covaria::ui
