// Round numbers (1, 2, 5 times a power of ten) and their texts.
#pragma once

#include <string>

namespace covaria {

double nearest_round_number(double value);  ///< in ratio; value > 0
double round_number_below(double value);    ///< the largest that is not larger; value > 0

/// Shortest text with `decimals`, true minus sign, thin spaces between thousands from 10 000 on.
std::string plain_number(double value, int decimals);
/// A round number without superfluous decimals: "2000", "0.5".
std::string round_number_text(double value);
/// "95 %", "95.45 %".
std::string percent_text(double probability);

}  // namespace covaria
