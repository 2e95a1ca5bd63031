// The figures of a typed component of uncertainty: the one place where they are converted.
//
// A component is a deviation from the estimate of its quantity. So all its figures, also a mean or a limit,
// are differences: they are converted without the zero of degC.
#pragma once

#include "core/project/project.h"
#include "core/quantity/input_quantity.h"
#include "core/text/document_language.h"

namespace covaria {

/// The distribution that the edit states. Errors: those of `distribution_from`.
Result<Distribution> distribution_of(const ComponentEdit& edit);
/// The distribution that Monte Carlo draws for the edit, as for a component with its degrees of freedom
/// (core/quantity). Errors: those of `distribution_from`.
Result<Distribution> drawn_distribution(const ComponentEdit& edit, bool normal_draws);
/// Degrees of freedom of the edit's standard uncertainty: those stated, else those of its distribution.
double degrees_of_freedom_of(const ComponentEdit& edit, const Distribution& distribution);
/// Puts kind and parameters of `distribution` (SI) into the edit, in its unit.
void set_distribution(ComponentEdit& edit, const Distribution& distribution);
/// The same component with its parameters in another unit of the same dimension.
ComponentEdit in_unit(ComponentEdit edit, const Unit& unit);
/// The edit that would give this component.
ComponentEdit to_edit(const UncertaintyComponent& component,
                      const DocumentLanguage& in = DocumentLanguage::english());

}  // namespace covaria
