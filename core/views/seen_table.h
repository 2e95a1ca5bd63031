// Stated uncertainties beside those that the residuals of an analysis see, as a table and in words.
#pragma once

#include <memory>
#include <vector>

#include "core/evidence/seen.h"
#include "core/text/document_language.h"
#include "core/text/table.h"

namespace covaria {

/// The table with a row for each stated figure. Columns: figure, readings, u_stated, u_stated_most (where
/// readings of one differ), u_seen, factor, factor_low, factor_high, redundancy, degrees_of_freedom, verdict.
Table seen_table(const evidence::RedundantReadings& readings, const evidence::Seen& seen,
                 const DocumentLanguage& in = DocumentLanguage::english());
/// The words of a verdict: "seen is larger".
Message verdict_words(evidence::Verdict verdict);
/// Sentences on the global test and what it does not see, on components that are zero or cannot be told
/// apart, and on the mean u of a coordinate that follows; or why there is no table.
std::vector<Message> seen_notes(const evidence::RedundantReadings& readings, const evidence::Seen& seen);

}  // namespace covaria
