// Figures of Suncal (Sandia): numbers, shares of a value or of a range, and the statements that they make.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/readers/stated_budget.h"

namespace covaria {

/// The number of a figure "5%", "0.01% + .00001*100", "10 ppm + .01%range(10)": a sum of products in the unit
/// of `mean`, of which %, ppm and ppb are shares; the share of a range is one of its argument. It is empty
/// where the text is none.
std::optional<double> suncal_figure(const std::string& text, double mean);

/// Gives the component the statement of a distribution of Suncal with its figures, and says in `how` what was
/// concluded. The answer names what cannot be taken over, and is empty otherwise.
std::string state_suncal(const std::string& distribution, const std::map<std::string, double>& figures,
                         NotedComponent& component, std::string& how);

}  // namespace covaria
