// The table of an analysis of variance: sums of squares, degrees of freedom, mean squares, F and its p.
#pragma once

#include <string>

#include "core/text/table.h"

namespace covaria {

/// A source of variation: one line of the table.
struct VarianceSource {
    Message name;
    double sum_of_squares = 0.0;  ///< SI
    double degrees_of_freedom = 0.0;
    double mean_square() const { return sum_of_squares / degrees_of_freedom; }
};

/// `unit`: of differences of the observed quantity. F is the ratio of the effect's mean square to the rest's,
/// empty where the latter is zero.
Table variance_table(std::string id, std::string title, const Unit& unit, const VarianceSource& effect,
                     const VarianceSource& rest);

}  // namespace covaria
