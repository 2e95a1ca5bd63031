// Units as pint (Python) writes them.
#pragma once

#include <string>

#include "core/base/unit.h"

namespace covaria {

/// A unit of others: one that Covaria has, or a multiple of one, on a scale with another zero.
struct PintUnit {
    Unit unit = {};
    double scale = 1.0;  ///< factor to `unit`
    double zero = 0.0;   ///< reading where `unit` reads 0

    double value(double stated) const { return (stated - zero) * scale; }
    double interval(double stated) const { return stated * scale; }
    bool is_converted() const { return scale != 1.0 || zero != 0.0; }
};

/// The unit of a text such as "meter / second ** 2", "delta_degC", "kiloohms", "inch_H2O". Error: no unit
/// that is known.
Result<PintUnit> unit_of_pint(const std::string& text);

}  // namespace covaria
