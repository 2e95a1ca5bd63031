// The place where a component of a budget is stated, to go there.
#pragma once

#include <QString>

#include "core/made/made_project.h"
#include "core/result/uncertainty_result.h"

namespace covaria::ui {

/// JSON pointer into the project: the asset or analysis that brings it in, the row or field of the set-up
/// that states it, else its input quantity. Empty where the project no longer has it.
QString place_of_component(const Project& project, const PreparedAnalysis& analysis,
                           const BudgetComponent& component);

}  // namespace covaria::ui
