// Leica GSI-8 and GSI-16: blocks of words of fixed width.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// The content of one block; lengths in m, angles in rad. Distances of zero are none.
struct GsiBlock {
    int line = 0;
    std::string point;
    std::optional<double> azimuth, zenith, distance;  ///< words 21, 22, 31: Hz clockwise, V from the zenith
    std::optional<double> target[3], station[3];      ///< words 81-83 and 84-86: E, N, H
    std::optional<double> target_height, instrument_height;
    std::vector<int> others;  ///< indices of words that are not read
};

/// The blocks of a text. Words are counted off, never split at blanks, and a block begins with word 11 or 41
/// to 49, so that files without line ends are read. Error with line and column: a word that is none, a unit
/// that is unknown.
Result<std::vector<GsiBlock>> read_gsi(const std::string& text);

/// Whether a text begins like a block.
bool is_gsi(std::string_view text);

}  // namespace covaria
