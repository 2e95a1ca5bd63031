// Points with coordinates, as files list them, and the entries made of them: an artefact for each group, and
// their own figures in one analysis.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/readers/reader.h"
#include "core/readers/stated_quantities.h"

namespace covaria {

struct ListedPoint {
    int line = 0;
    std::string name = {}, group = {};
    std::array<double, 3> p{};                 ///< coordinates in the unit of the list
    std::array<std::optional<double>, 3> u{};  ///< standard uncertainties in the unit of the list
};

/// The most points of a list; more are refused, because their project could not be saved.
inline constexpr std::size_t most_listed_points = 300'000;

struct PointCorrelation {
    std::size_t first = 0, second = 0;  ///< indices 3 * point + coordinate
    double coefficient = 0.0;
};

struct PointList {
    std::string title;  ///< title of the file: "Jig 7"
    Unit unit = Unit::of("mm");
    std::string source;  ///< source in words: "SpatialAnalyzer points, jig.txt"
    std::vector<ListedPoint> points = {};
    std::vector<PointCorrelation> correlations = {};
};

/// Proposes an artefact for each group, whose u_cal in x, y, z is the largest one of its points; where points
/// have different ones, or correlated ones, an analysis with the figures of each too. The messages in `found`
/// say so, and those in `left_out` what that does not hold. Error: no points.
Result<void> propose_points(PointList list, Proposals& proposals);

}  // namespace covaria
