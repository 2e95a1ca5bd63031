// Units of the D-SI (digital system of units): "\milli\metre\tothe{2}", "\metre\per\second".
#pragma once

#include <string>

#include "core/base/unit.h"

namespace covaria {

/// Error: not written so, a name that is unknown, or a level (decibel) that is no multiple of a unit.
Result<Unit> unit_of_dsi(const std::string& text);

}  // namespace covaria
