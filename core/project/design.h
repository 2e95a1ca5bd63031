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
    std::size_t keep = 0;                 ///< how many rows stay; at most, where it is about cost
    std::vector<std::size_t> fixed = {};  ///< rows that always stay
    std::string candidates = {};          ///< CSV file beside the project: rows behind those of the table
    std::vector<double> prices = {};      ///< of each row, or one for all; empty: rows cost nothing
    double price_of(const std::vector<std::size_t>& rows) const;
    bool operator==(const DesignChoice&) const = default;
};

/// What it costs to have f times a standard uncertainty: nothing at f = 1, `price` at f = 1/2, convex in f².
enum class PriceLaw {
    inverse,      ///< price · (1/f − 1)
    repeats,      ///< price · (1/f² − 1)/3: further readings whose mean is taken
    logarithmic,  ///< price · log2(1/f): every halving costs the same
};

/// A number that uncertainties are proportional to, and what its reduction costs.
struct DesignReduction {
    /// `from`: the smallest factor that can be had; `to`: 1.
    StudyAxis number = {.change = StudyChange::factor, .from = 0.1, .to = 1.0, .values = 2};
    double price = 1.0;  ///< of the first halving
    PriceLaw law = PriceLaw::inverse;
    bool operator==(const DesignReduction&) const = default;
};

/// What is made of the ratios U/target; the smallest is the best. Or the price of the rows, with which no
/// ratio is above 1.
enum class DesignObjective { largest, mean, root_mean_square, cost };

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
    /// Instead of variables and rows: the cheapest of these so that all targets are met.
    std::vector<DesignReduction> reductions = {};
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
