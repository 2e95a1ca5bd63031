// A document in text formats.
#pragma once

#include <string>
#include <vector>

#include "core/document/report_document.h"

namespace covaria {

std::string to_markdown(const ReportDocument& document);  ///< figures as "ID.png" / "ID.svg" beside the file
std::string to_html(const ReportDocument& document);      ///< one file; figures beside it as in Markdown
std::string html_body(const std::vector<ReportBlock>& blocks);  ///< the part between <body> and </body>

}  // namespace covaria
