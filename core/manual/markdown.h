// The Markdown of the help pages as blocks of a document: headings, paragraphs, lists, tables, lines of code,
// pictures;
// **strong**, *emphasised*, `code`, [links](target).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/document/report_document.h"

namespace covaria {

/// Headings get anchors: `page` for the first, "page-words-of-the-heading" for the others. Pictures are
/// looked for beside `folder`.
std::vector<ReportBlock> blocks_of_markdown(const std::string& text, const std::string& page,
                                            const std::filesystem::path& folder = {});
std::vector<ProseSpan> spans_of_markdown(const std::string& text);
/// "What Every Analysis has" -> "what-every-analysis-has".
std::string anchor_words(const std::string& heading);

}  // namespace covaria
