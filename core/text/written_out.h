// Extent of written numbers: which results have no power of ten (50 000 840 ± 180), how many digits.
#pragma once

namespace covaria {

inline constexpr double smallest_written_out = 1e-4;
inline constexpr double largest_written_out = 1e10;
inline constexpr int most_rounded_places = 3;  ///< before the point

/// Most decimals that the numbers of a column share; a number with more gives none.
inline constexpr int most_shared_decimals = 6;

/// Significant digits of a computed value without an uncertainty to match.
inline constexpr int computed_digits = 7;

/// `largest`: of the numbers that are read together; `decimals`: those that their uncertainty leaves.
constexpr bool is_written_out(double largest, int decimals) {
    return largest >= smallest_written_out && largest < largest_written_out &&
           decimals >= -most_rounded_places;
}

}  // namespace covaria
