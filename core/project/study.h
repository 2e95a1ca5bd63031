// A study of an analysis: its result over a grid of changed values (sweep, map).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/unit.h"
#include "core/propagation/options.h"

namespace covaria {

/// The use that an axis makes of its value to change the number that it varies.
enum class StudyChange {
    value,   ///< takes the number's place
    factor,  ///< is multiplied with the number
    added,   ///< is added to the number
};

enum class StudySpacing { linear, logarithmic };

/// One axis of the grid. `target` is a JSON pointer as in the project file, relative to the analysis or
/// asset:
///   /setup/KEY                        a number of the set-up
///   /setup/KEY/position/0 (angles/0)  a coordinate of a pose
///   /setup/KEY/rows/2/COLUMN          a cell of a table
///   /setup/KEY/columns/COLUMN         a column of a table, all rows
///   /inputs/SYMBOL/estimate           the estimate of an input quantity
///   /inputs/SYMBOL/components         all components of an input quantity (factor only)
///   /components/ID                    one component, wherever it contributes (factor only)
struct StudyAxis {
    /// Id of the asset, or of an analysis that this one takes from, whose set-up is varied; empty: the
    /// analysis itself.
    std::string asset = {};
    std::string target = {};
    StudyChange change = StudyChange::value;
    double from = 0.0;
    double to = 1.0;
    Unit unit = {};  ///< unit of `from` and `to`; the unit one for a factor
    std::size_t values = 11;
    StudySpacing spacing = StudySpacing::linear;
    bool operator==(const StudyAxis&) const = default;
};

struct StudyOutput {
    std::string group, symbol;
    bool operator==(const StudyOutput&) const = default;
};

struct Study {
    std::string id;  ///< id, unique in the analysis: letters, digits, '-' and '_'
    std::string name = {};
    std::vector<StudyAxis> axes = {};       ///< axes, one to three; the last one varies fastest
    std::vector<StudyOutput> outputs = {};  ///< outputs that are looked at; empty: all measurands
    Method method = Method::first_order;    ///< first_order or monte_carlo
    std::uint64_t trials = 100'000;         ///< trials of Monte Carlo at each grid point
    bool operator==(const Study&) const = default;
};

inline constexpr std::size_t most_study_points = 1'000'000;

/// The values of an axis in its unit; whole numbers for a target that counts something.
std::vector<double> axis_values(const StudyAxis& axis, bool whole_numbers);

}  // namespace covaria
