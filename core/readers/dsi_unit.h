// Units of the D-SI (digital system of units): "\milli\metre\tothe{2}", "\metre\per\second".
#pragma once

#include <string>

#include "core/base/unit.h"

namespace covaria {

/// The unit of a D-SI text. Error: it is not written so, a name is unknown, or it is a level (decibel), which
/// is no multiple of a unit.
Result<Unit> unit_of_dsi(const std::string& text);

/// A unit that has a name in the D-SI.
struct DsiUnit {
    std::string text;  ///< text of the unit: "\milli\metre"
    Unit unit;         ///< the same unit
};
/// The D-SI unit for `unit`, or for the coherent SI unit of its dimension where the D-SI has no name for it
/// ("in" is stated in metres).
DsiUnit dsi_unit_for(const Unit& unit);
/// The D-SI text for products of differences: a covariance.
std::string dsi_product(const DsiUnit& a, const DsiUnit& b);

}  // namespace covaria
