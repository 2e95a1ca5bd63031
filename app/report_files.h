// The report of evaluated analyses as files: PDF, HTML, Markdown and the figures they show.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/evaluation.h"
#include "core/carried/report_data.h"

namespace covaria {

struct ReportFiles {
    std::string folder = "out";
    std::vector<std::string> formats = {};  ///< "pdf", "html", "markdown"; empty = all
    std::string paper = "a4";
    std::string name = "report";  ///< name of the files, without ending
};

/// The folder, name and format of one file: "out/cert.pdf". Error{usage}: its ending names no format.
Result<void> write_into_one_file(const std::string& file, ReportFiles& files);

/// Writes a document that shows no pictures and carries no project.
Result<void> write_document(const ReportDocument& document, const ReportFiles& files,
                            const std::stop_token& stop);
/// Writes a document of any kind: a report, a certificate.
Result<void> write_document(const ReportDocument& document, const ReportSource& source,
                            const ReportFiles& files, const std::stop_token& stop);

}  // namespace covaria
