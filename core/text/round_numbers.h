// Round numbers: 1, 2, 5 times a power of ten.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace covaria {

/// The distance from `value` to the next number of that size: steps of an axis that are smaller are none.
double resolution_at(double value);
/// The multiples of `step` in [low, high], rising, each another number. They are counted as whole numbers, so
/// that no range and no step makes it go on for ever. Empty where there would be more than `most`.
std::vector<double> multiples_between(double low, double high, double step, std::size_t most);

double nearest_round_number(double value);  ///< nearest in ratio; value > 0
double round_number_below(double value);    ///< the largest that is not larger; value > 0
double round_number_above(double value);    ///< the smallest that is not smaller; value > 0

/// A value to so many significant digits, never up, for what must not be exceeded. value >= 0
double rounded_down(double value, int digits);

/// Decimals that show a multiple of `step`.
int decimals_of_step(double step);
/// A round number without superfluous decimals: "2000", "0.5".
std::string round_number_text(double value);

}  // namespace covaria
