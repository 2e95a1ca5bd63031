// The prose of help pages, written for those who set it.
#pragma once

#include <string>

#include "core/document/report_document.h"

namespace covaria {

enum class Links { shown, dropped };
/// HTML for the inside of a paragraph.
std::string prose_html(const std::vector<ProseSpan>& spans, Links links);
/// The words alone.
std::string prose_words(const std::vector<ProseSpan>& spans);

}  // namespace covaria
