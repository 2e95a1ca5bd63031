// The rows of a set-up that a link to another analysis replaces.
#pragma once

#include <map>
#include <string>

#include "core/made/made_entry.h"
#include "core/project/project.h"

namespace covaria::ui {

/// Rows of the set-up's tables ("/quantities/rows/3") that state one input quantity, or a component of it,
/// whose value a link of the analysis gives. A row of several quantities (the coordinates of a point) is none
/// of them: nobody here knows what else the model makes of it.
std::map<std::string, InputLink> taken_rows(const AnalysisEntry& analysis, const MadeAnalysis& made);

}  // namespace covaria::ui
