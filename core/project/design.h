// A design of an analysis: which numbers may be chosen, which rows of a table may be taken, and what for.
#pragma once

#include <array>
#include <optional>

#include "core/project/study.h"

namespace covaria {

/// A number of the project that may be chosen.
struct DesignVariable {
    StudyAxis number = {.values = 2};  ///< between `from` and `to`; number and spacing of values mean nothing
    double tolerance = 0.0;            ///< in the number's unit: it can be put into effect only so well
    bool operator==(const DesignVariable&) const = default;
};

/// Rows of a table that are candidates: stations, poses, points, places of ballbars.
struct DesignChoice {
    std::string asset = {};               ///< id of the asset whose table it is; empty: the analysis itself
    std::string table = {};               ///< "/setup/KEY/rows"
    std::size_t keep = 0;                 ///< how many rows stay
    std::vector<std::size_t> fixed = {};  ///< rows that always stay
    std::string candidates = {};          ///< CSV file beside the project: rows behind those of the table
    bool operator==(const DesignChoice&) const = default;
};

/// What is made of the ratios U/target; the smallest is the best.
enum class DesignObjective { largest, mean, root_mean_square };

/// A box along the axes of the world.
struct DesignBox {
    std::string name = {};
    std::array<double, 3> from{}, to{};  ///< in `unit`
    Unit unit = Unit::of("mm");
    bool operator==(const DesignBox&) const = default;
};

struct Design {
    std::string id;  ///< unique in the analysis: letters, digits, '-' and '_'
    std::string name = {};
    std::vector<DesignVariable> variables = {};
    std::optional<DesignChoice> choose = {};
    /// Looked at; empty: all with a target uncertainty, or where none has one, all measurands.
    std::vector<StudyOutput> outputs = {};
    DesignObjective objective = DesignObjective::largest;
    std::optional<Quantity> least_distance = {};  ///< between instruments, and of them from other points
    std::vector<DesignBox> keep_out = {};         ///< no instrument stands in them
    std::vector<DesignBox> hidden_by = {};        ///< no line of sight passes them
    std::size_t starts = 10;                      ///< of the search: the present design and random ones
    std::uint64_t seed = 1;
    std::uint64_t most_evaluations = 20'000;
    std::uint64_t trials =
        0;  ///< of the Monte Carlo run that verifies the chosen design; 0: those of the analysis
    bool operator==(const Design&) const = default;
};

inline constexpr std::size_t most_design_variables = 100;
inline constexpr std::size_t most_design_starts = 10'000;

}  // namespace covaria
