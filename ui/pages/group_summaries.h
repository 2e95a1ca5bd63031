// Summaries of an analysis' groups, shown in their heads.
#pragma once

#include "core/project/project.h"
#include "ui/run/run_state.h"

namespace covaria::ui {

class FoldGroups;

/// Groups in their order in the inspector.
enum AnalysisGroup {
    setup_group,
    inputs_group,
    options_group,
    studies_group,
    designs_group,
    requirements_group,
    certificates_group,
    notes_group
};

/// Writes into each head what is in its group.
void summarise_groups(FoldGroups& groups, const AnalysisEntry& analysis, const AnalysisStatus& status);

}  // namespace covaria::ui
