// Units of the D-SI (digital system of units): "\milli\metre\tothe{2}", "\metre\per\second".
#pragma once

#include <string>

#include "core/base/unit.h"

namespace covaria {

/// Error: not written so, a name that is unknown, or a level (decibel) that is no multiple of a unit.
Result<Unit> unit_of_dsi(const std::string& text);

/// A unit that has a name in the D-SI.
struct DsiUnit {
    std::string text;  ///< "\milli\metre"
    Unit unit;         ///< the same
};
/// Of `unit`, or of the coherent SI unit of its dimension where the D-SI has no name for it ("in" is stated
/// in metres).
DsiUnit dsi_unit_for(const Unit& unit);
/// Of products of differences: a covariance.
std::string dsi_product(const DsiUnit& a, const DsiUnit& b);

}  // namespace covaria
