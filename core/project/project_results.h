// The statements of a project about the results of all its analyses.
#pragma once

#include <optional>

#include "core/result/result_style.h"

namespace covaria {

struct ProjectResults {
    ResultStyle style = {};
    /// The factor k for U = k u of the analyses that state none, greater than zero; empty: as they are.
    std::optional<double> coverage_factor = {};

    bool empty() const { return *this == ProjectResults{}; }
    bool operator==(const ProjectResults&) const = default;
};

}  // namespace covaria
