// A study as a table for people.
#pragma once

#include "core/result/study_result.h"
#include "core/text/document_language.h"
#include "core/text/table.h"

namespace covaria {

/// A study as people read it: axes as they were typed, what is looked at of the outputs, remarks where there
/// are any. Reads the study when it is asked for cells.
Table study_view(const StudyResult& study, const DocumentLanguage& in);

}  // namespace covaria
