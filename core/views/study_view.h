// A study as a table for people.
#pragma once

#include "core/result/study_result.h"
#include "core/text/document_language.h"
#include "core/text/table.h"

namespace covaria {

/// The table of a study as people read it: axes as they were typed, the figures of the outputs that are
/// looked at, remarks where there are any. It reads the study when it is asked for cells.
Table study_view(const StudyResult& study, const DocumentLanguage& in);

}  // namespace covaria
