// The chapters of a report's analyses, put into the room that there is; internal to core/report.
#pragma once

#include "core/report/report_parts.h"

namespace covaria::report_parts {

/// `body`: an analysis after the other, in at most `lines` lines of print, roughly. `annex`: what was
/// shortened or left out for its length, whole.
struct AnalysisChapters {
    Blocks body, annex;
};
AnalysisChapters analysis_chapters(const ReportSource& source, const ReportContents& contents, double lines);

}  // namespace covaria::report_parts
