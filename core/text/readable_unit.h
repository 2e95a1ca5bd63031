// The unit in which a number is read best.
#pragma once

#include "core/base/unit.h"

namespace covaria {

/// `usual`, or of the units that differ from it by powers of 1000 the one in which an interval of `si` has
/// one to three digits before the point.
Unit readable_unit(double si, const Unit& usual);

}  // namespace covaria
