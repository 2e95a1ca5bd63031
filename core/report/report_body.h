// The chapters of a report's analyses, put into the room that there is; internal to core/report.
#pragma once

#include "core/report/report_parts.h"

namespace covaria::report_parts {

/// `body` has the analyses one after the other, in at most `lines` lines of print, roughly. `annex` has whole
/// what was shortened or left out for its length.
struct AnalysisChapters {
    Blocks body, annex;
};
AnalysisChapters analysis_chapters(const ReportSource& source, const ReportContents& contents, double lines);

/// The same on a sheet, without an annex: chapter by chapter, each as much of it as fits into what those
/// before it leave of `lines`. `source` has one analysis.
Blocks sheet_chapters(const ReportSource& source, const ReportContents& contents, double lines);

}  // namespace covaria::report_parts
