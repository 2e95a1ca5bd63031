// The parts of an analysis beside its set-up, in project files: input edits, correlations, options,
// requirements, studies, designs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/project/json_writer.h"
#include "core/project/object_reader.h"
#include "core/project/project.h"

namespace covaria {

/// Read "inputs", "correlations", "options", "requirements", "studies" and
/// "designs" of the analysis at `path`.
void read_analysis_details(ObjectReader& reader, AnalysisEntry& analysis);
/// Writes those that are not empty or default.
void write_analysis_details(JsonWriter& out, const AnalysisEntry& analysis);

}  // namespace covaria
