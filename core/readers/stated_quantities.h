// Quantities as a certificate or a list states them, as a measurement equation in which each is its own
// result.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/project/project.h"

namespace covaria {

/// One stated quantity. Figures are in `unit`, uncertainties in its interval (K for degC).
struct StatedQuantity {
    std::string symbol;  ///< name that equations may use: "x_1"
    std::string name;
    double value = 0.0;
    Unit unit = {};
    std::string statement = {};  ///< key of a statement; empty: no uncertainty is stated
    std::optional<double> a = {}, b = {}, degrees_of_freedom = {};
    std::string source = {};
    std::string group = {};  ///< results of one group have a joint region
};

struct StatedCorrelation {
    std::size_t first = 0, second = 0;  ///< indices of quantities
    double coefficient = 0.0;
};

/// The most quantities that are put into one analysis.
inline constexpr std::size_t most_stated_quantities = 300;

/// The analysis of quantities, each of which becomes an input quantity "x_1" and a result "y_x_1" hereof;
/// people write their own equations below or instead. Correlations of 0 are left out.
AnalysisEntry analysis_of(const std::string& id, const std::string& name, const std::string& notes,
                          const std::vector<StatedQuantity>& quantities,
                          const std::vector<StatedCorrelation>& correlations = {});

}  // namespace covaria
