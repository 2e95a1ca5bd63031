// Edits of an analysis applied to the input quantities of its model.
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

/// The model's inputs with the analysis' edits and correlations. Problems have paths relative to the analysis
/// ("/inputs/0/estimate"). The indices of the model's own components stay, so their random draws do too:
/// replaced components take the places of those they replace ("b_1x.edit1", "b_1x.edit2" ...), and more are
/// appended. Components of one point (`local`) are replaced in the edited coordinate and stay in the others;
/// those that a quantity shares with other points or quantities stay.
///
/// Components are deviations from the estimate (component_edit.h). After all edits of a quantity its estimate
/// is the edited one, whatever the means of its components. A held quantity is constant at its estimate;
/// components that it shares with others stay in those.
///
/// A correlation names a component by its id or a quantity by its symbol. A correlation of a quantity as a
/// whole applies to the total deviation: two components get r times their correlations with the totals that
/// they are part of.
InputSet apply_edits(InputSet inputs, const AnalysisEntry& analysis, Problems& problems);

/// Applies the correlations alone, in place of those that the model declares.
void apply_correlations(InputSet& inputs, const std::vector<CorrelationEdit>& edits, Problems& problems);

}  // namespace covaria
