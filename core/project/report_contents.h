// The part of a project that goes into its report: project file, its JSON schema, form and report follow the
// one list of chapters.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// The chapters, by their keys in files; each but the first and the last two is a chapter of an analysis.
enum class ReportChapter {
    models,
    setup,
    inputs,
    assets,
    budgets,
    influence,
    evaluation,
    comparison,
    before,
    regions,
    distributions,
    scene,
    correlation,
    studies,
    designs,
    notes,
    provenance
};

struct ReportChapterField {
    ReportChapter chapter;
    const char* key;    ///< the key in files
    const char* title;  ///< the title for people
};
/// The chapters in the order of the report.
const std::vector<ReportChapterField>& report_chapters();

/// The contents of a report: everything that is not left out, so that chapters which are added later are in
/// it too. Results are always there.
struct ReportContents {
    std::vector<std::string> without_analyses = {};  ///< ids of analyses
    std::vector<std::string> without_chapters = {};  ///< keys of chapters
    bool annex = false;                              ///< whether long tables stand whole at the end

    bool empty() const { return *this == ReportContents{}; }
    bool has_analysis(const std::string& id) const;
    bool has(ReportChapter chapter) const;
    bool operator==(const ReportContents&) const = default;
};

/// Notes whether a part goes into the report (`on`) or is left out.
void choose(std::vector<std::string>& without, const std::string& key, bool on);

/// Reports chapters that there are none of, and warns of analyses that are not in `analyses`, the ids of
/// those of the project. Paths are from the root of the project.
void check_report_contents(const ReportContents& contents, const std::vector<std::string>& analyses,
                           Problems& problems);

}  // namespace covaria
