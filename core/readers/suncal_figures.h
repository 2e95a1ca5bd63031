// Figures of Suncal (Sandia): numbers, shares of a value or of a range, and the statements that they make.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/readers/stated_budget.h"

namespace covaria {

/// "5%", "0.01% + .00001*100", "10 ppm + .01%range(10)": a sum of products in the unit of `mean`, of which %,
/// ppm and ppb are shares; of a range the share is that of its argument. Empty: it is none.
std::optional<double> suncal_figure(const std::string& text, double mean);

/// What a distribution of Suncal and its figures mean. Empty, or what cannot be taken over; `how` says what
/// was concluded.
std::string state_suncal(const std::string& distribution, const std::map<std::string, double>& figures,
                         NotedComponent& component, std::string& how);

}  // namespace covaria
