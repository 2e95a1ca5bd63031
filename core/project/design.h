// A design of an analysis: the numbers that may be chosen, the rows of a table that may be taken, and the aim
// of the choice.
#pragma once

#include <array>
#include <optional>

#include "core/project/study.h"

namespace covaria {

/// A number of the project that may be chosen.
struct DesignVariable {
    /// Range of the number, `from` to `to`; its number and spacing of values mean nothing.
    StudyAxis number = {.values = 2};
    double tolerance = 0.0;  ///< how well the number can be put into effect, in its unit
    bool operator==(const DesignVariable&) const = default;
};

/// Rows of a table that are candidates: stations, poses, points, places of ballbars.
struct DesignChoice {
    std::string asset = {};  ///< id of the asset that has the table; empty: the analysis itself
    std::string table = {};  ///< place of the table: "/setup/KEY/rows"
    /// Number of rows that stay; where the objective is cost, the most that do.
    std::size_t keep = 0;
    std::vector<std::size_t> fixed = {};  ///< indices of rows that always stay
    /// CSV file beside the project with rows that follow those of the table.
    std::string candidates = {};
    std::vector<double> prices = {};  ///< price of each row, or one for all; empty: rows cost nothing
    double price_of(const std::vector<std::size_t>& rows) const;
    bool operator==(const DesignChoice&) const = default;
};

/// The law of the price of having f times a standard uncertainty: nothing at f = 1, `price` at f = 1/2,
/// convex in f².
enum class PriceLaw {
    inverse,      ///< the price is price · (1/f − 1)
    repeats,      ///< the price is price · (1/f² − 1)/3: further readings whose mean is taken
    logarithmic,  ///< the price is price · log2(1/f): every halving costs the same
};

/// A number that uncertainties are proportional to, and the price of its reduction.
struct DesignReduction {
    /// `from` is the smallest factor that can be had, `to` is 1.
    StudyAxis number = {.change = StudyChange::factor, .from = 0.1, .to = 1.0, .values = 2};
    double price = 1.0;  ///< the price of the first halving
    PriceLaw law = PriceLaw::inverse;
    bool operator==(const DesignReduction&) const = default;
};

/// The figure made of the ratios U/target, which the best design has smallest; or the price of the rows, with
/// which no ratio is above 1.
enum class DesignObjective { largest, mean, root_mean_square, cost };

/// A box along the axes of the world.
struct DesignBox {
    std::string name = {};
    std::array<double, 3> from{}, to{};  ///< opposite corners of the box, in `unit`
    Unit unit = Unit::of("mm");
    bool operator==(const DesignBox&) const = default;
};

struct Design {
    std::string id;  ///< id, unique in the analysis: letters, digits, '-' and '_'
    std::string name = {};
    std::vector<DesignVariable> variables = {};
    std::optional<DesignChoice> choose = {};
    /// Reductions instead of variables and rows: the cheapest ones with which all targets are met are sought.
    std::vector<DesignReduction> reductions = {};
    /// The outputs that are looked at; empty: all with a target uncertainty, or where none has one, all
    /// measurands.
    std::vector<StudyOutput> outputs = {};
    DesignObjective objective = DesignObjective::largest;
    /// Least distance between instruments, and of them from other points.
    std::optional<Quantity> least_distance = {};
    std::vector<DesignBox> keep_out = {};   ///< boxes that no instrument stands in
    std::vector<DesignBox> hidden_by = {};  ///< boxes that no line of sight passes
    /// Number of starts of the search: the present design and random ones.
    std::size_t starts = 10;
    std::uint64_t seed = 1;
    std::uint64_t most_evaluations = 20'000;
    /// Number of trials of the Monte Carlo run that verifies the chosen design; 0: those of the analysis.
    std::uint64_t trials = 0;
    bool operator==(const Design&) const = default;
};

inline constexpr std::size_t most_design_variables = 100;
inline constexpr std::size_t most_design_starts = 10'000;

}  // namespace covaria
