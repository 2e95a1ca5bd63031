// Short names of the rows of a budget that tell them apart: in tables of the window and at the bars of
// charts.
#pragma once

#include <functional>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/text/document_language.h"
#include "core/text/table.h"

namespace covaria {

/// Labels of components: "b₁ₓ" if that names the component among these rows, else "b₁ₓ, calibration"; where
/// several quantities share the component the name alone, after its owner: "b₁: Laser tracker, azimuth".
std::vector<Text> component_labels(const std::vector<const BudgetComponent*>& components,
                                   const DocumentLanguage& in);
/// Labels of the components of these rows.
std::vector<Text> component_labels(const UncertaintyBudget& budget, const std::vector<BudgetRow>& rows,
                                   const DocumentLanguage& in);

/// Adds the column "label" to a table with a row for each of them, for the window. They are made when a cell
/// is asked for, because files of thousands of rows have none.
void add_label_column(Table& table, std::function<std::vector<Text>()> labels);

}  // namespace covaria
