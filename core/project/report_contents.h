// What of a project goes into its report: project file, its JSON schema, form and report follow the one list
// of chapters.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// By their keys in files; of an analysis, but for the first and the last two.
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
    const char* key;    ///< in files
    const char* title;  ///< for people
};
/// In the order of the report.
const std::vector<ReportChapterField>& report_chapters();

/// All goes in that is not left out, so that what is added later does. Results are always there.
struct ReportContents {
    std::vector<std::string> without_analyses = {};  ///< ids
    std::vector<std::string> without_chapters = {};  ///< keys
    bool annex = false;                              ///< long tables stand whole at the end

    bool empty() const { return *this == ReportContents{}; }
    bool has_analysis(const std::string& id) const;
    bool has(ReportChapter chapter) const;
    bool operator==(const ReportContents&) const = default;
};

/// `on`: it goes in.
void choose(std::vector<std::string>& without, const std::string& key, bool on);

/// Chapters that there are none of; `analyses`: ids of those of the project, others are warned of. Paths from
/// the root of the project.
void check_report_contents(const ReportContents& contents, const std::vector<std::string>& analyses,
                           Problems& problems);

}  // namespace covaria
