// Closures of readings, which need no adjustment.
#pragma once

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

struct Closure {
    Message words;
    double misclosure = 0.0, u = 0.0;  ///< in SI
    Unit unit;                         ///< unit in which it is shown
    std::string source;                ///< place of its last reading
    std::vector<std::size_t> rows;     ///< rows of its readings in the table of readings
    double ratio() const;
};

/// The closures of a network, the largest for its u first.
std::vector<Closure> closures(const AdjustedNetwork& network);
/// Warns of closures that are larger than the uncertainties allow.
void check_closures(const AdjustedNetwork& network, Problems& problems);
Table closures_table(const std::vector<Closure>& closures);
/// Index and collimation of the instruments whose sights were read in both faces; none where none was.
std::optional<Table> faces_table(const AdjustedNetwork& network);

}  // namespace covaria::network
