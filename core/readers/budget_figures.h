// The figures of one line of a budget, and the statement of uncertainty that they make.
#pragma once

#include <optional>
#include <string>

#include "core/readers/stated_budget.h"

namespace covaria {

/// The figures as the line states them, in its unit.
struct BudgetFigures {
    std::optional<double> standard = {}, expanded = {}, limits = {}, divisor = {}, nu = {};
    std::string distribution = {};  ///< distribution in words: "rectangular", "Rechteck", "U-shaped"
};

/// The component that the figures state. `how` says "normal, k = 2" ... where something was concluded that
/// the line does not say in so many words. Error (without place): no uncertainty, figures that contradict
/// each other, a distribution that is not known.
Result<NotedComponent> stated_component_of(const BudgetFigures& figures, std::string& how);

/// Standard uncertainty, in SI, of a component that `stated_component_of` made.
double standard_uncertainty_of(const NotedComponent& component);

/// Whether a line is headed as one of sums: "Combined standard uncertainty", "Summe".
bool is_sum_label(const std::string& label);

/// The divisor in a text such as "√3", "sqrt(3)" or "2"; empty where it is none.
std::optional<double> divisor_in_text(const std::string& text);

}  // namespace covaria
