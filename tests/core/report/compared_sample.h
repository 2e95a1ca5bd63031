// Two results made by hand: of the same model before and after a change.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/result/comparison.h"

namespace covaria::test {

struct SampleComponent {
    std::string id, name, quantity;
    double contribution_um = 0.0;
};

/// An output in mm of independent components with c = 1; k = 2 by the law of propagation.
inline void add_sample_output(UncertaintyResult& result, const std::string& symbol, const std::string& group,
                              double estimate, const std::vector<SampleComponent>& components) {
    OutputResult output;
    output.quantity = {symbol, "length " + symbol, Unit::of("mm"), group};
    double variance = 0.0;
    for (const SampleComponent& c : components) variance += std::pow(1e-6 * c.contribution_um, 2);
    output.estimate = output.first_order.estimate = estimate;
    output.standard_uncertainty = output.first_order.standard_uncertainty = std::sqrt(variance);
    output.coverage_factor = output.first_order.coverage_factor = 2.0;
    output.expanded_uncertainty = output.first_order.expanded_uncertainty = 2.0 * std::sqrt(variance);
    std::vector<BudgetRow> rows;
    for (const SampleComponent& c : components) {
        BudgetComponent component;
        component.id = c.id;
        component.name = c.name;
        component.unit = Unit::of("um");
        component.quantities = {c.quantity};
        component.standard_uncertainty = 1e-6 * c.contribution_um;
        const double contribution = component.standard_uncertainty;
        rows.push_back({result.budget.components.size(), 1.0, contribution,
                        contribution * contribution / variance, std::nullopt});
        result.budget.components.push_back(std::move(component));
    }
    result.budget.rows.push_back(std::move(rows));
    result.outputs.push_back(std::move(output));
}

/// A comparison: u of x goes from 5 um (calibration 4, drift 3) to sqrt(45) um (a new one 6, drift 3); y
/// stays at 1 um; z is only before, w only after.
inline ResultComparison sample_comparison() {
    auto before = std::make_shared<UncertaintyResult>();
    add_sample_output(*before, "x", "pose 1", 0.1,
                      {{"l.cal", "calibration", "L", 4.0}, {"l.drift", "drift", "L", 3.0}});
    add_sample_output(*before, "y", "pose 1", 0.2, {{"y.read", "reading", "Y", 1.0}});
    add_sample_output(*before, "z", "pose 1", 0.3, {{"z.read", "reading", "Z", 1.0}});
    auto after = std::make_shared<UncertaintyResult>();
    add_sample_output(*after, "y", "pose 1", 0.2, {{"y.read", "reading", "Y", 1.0}});
    add_sample_output(*after, "x", "pose 1", 0.100002,
                      {{"m.temperature", "temperature", "theta", 6.0}, {"m.drift", "drift", "L", 3.0}});
    add_sample_output(*after, "w", "pose 1", 0.4, {{"w.read", "reading", "W", 1.0}});
    return compare_results(before, after);
}

}  // namespace covaria::test
