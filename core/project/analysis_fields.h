// An analysis beside its id and set-up, as project files have it: links, edits, correlations, options,
// requirements, studies, designs, views.
#pragma once

#include "core/project/json_fields.h"
#include "core/project/project.h"

namespace covaria {

const JsonFields<AnalysisEntry>& analysis_fields();

}  // namespace covaria
