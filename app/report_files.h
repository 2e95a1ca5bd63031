// The report of evaluated analyses as files: PDF, HTML, Markdown and the figures they show.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/evaluation.h"

namespace covaria {

struct ReportFiles {
    std::string folder = "out";
    std::vector<std::string> formats = {};  ///< "pdf", "html", "markdown"; empty = all
    std::string paper = "a4";
};

struct ReportSource {
    const MadeProject& made;
    const std::vector<EvaluatedAnalysis>& analyses;
    const std::vector<FailedAnalysis>& failed;
};

Result<void> write_reports(const ReportSource& source, const ReportFiles& files, const std::stop_token& stop);

}  // namespace covaria
