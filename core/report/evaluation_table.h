// Tables of models, assets and designs as people read them.
#pragma once

#include "core/base/data_table.h"
#include "core/document/report_document.h"

namespace covaria {

/// The head of a column has the unit that all its cells have, numbers that are read against each other share
/// their decimals, and what is zero but for rounding is shown as zero. Title and heads are said in `in`.
Table evaluation_table(const DataTable& made, const DocumentLanguage& in);
TableBlock evaluation_block(const DataTable& made, const DocumentLanguage& in);

}  // namespace covaria
