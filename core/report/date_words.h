// Dates as the reader of a document writes them: "27 November 2026".
#pragma once

#include <string>

#include "core/text/document_language.h"

namespace covaria {

/// The words for an ISO 8601 date, "2026-11-27", or for two with '/' between them ("17 April 2026 to 18 April
/// 2026"). A text that is neither stays as it is.
std::string date_words(const std::string& iso, const DocumentLanguage& in);

}  // namespace covaria
