// An uncertainty budget as a file states it: equations, quantities with their components of uncertainty.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/project/project.h"
#include "core/readers/stated_quantities.h"

namespace covaria {

/// One component of uncertainty. Figures are in `unit`.
struct NotedComponent {
    std::string name = {};
    std::string statement = {};  ///< key of a statement
    std::optional<double> a = {}, b = {}, degrees_of_freedom = {};
    Unit unit = {};
    std::string source = {};
};

struct NotedQuantity {
    std::string symbol, name = {};
    double value = 0.0;
    Unit unit = {};
    std::vector<NotedComponent> components = {};
    std::vector<double> observations = {};  ///< observations in `unit`; their mean is then the value
    /// Whether they were made with the others that are so: their means are correlated.
    bool observed_together = false;
};

struct NotedResult {
    std::string symbol, name = {};
    std::optional<Unit> unit = {};  ///< unit; empty: that of the equations
};

struct StatedBudget {
    std::string id, name, notes = {};
    std::string equations = {};
    std::vector<NotedQuantity> quantities = {};
    std::vector<NotedResult> results = {};
    std::vector<StatedCorrelation> correlations = {};  ///< correlations of quantities
};

AnalysisEntry analysis_of(const StatedBudget& budget);

/// Names of files as symbols that equations may use: "deltal_D" for "δl_D"; "x_7" where the text is none, or
/// is a function of the equations. No symbol is given twice.
class SymbolNames {
public:
    std::string take(const std::string& text);

private:
    std::set<std::string> taken_;
};

/// The complaint about a part of the equations that Covaria cannot read, empty if there is none: "columns
/// 4-7: ...".
Message equation_complaint(const std::string& equations);

}  // namespace covaria
