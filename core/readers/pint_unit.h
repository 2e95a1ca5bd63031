// Units as Python's pint writes them: "nanometer", "1 / delta_degC", "joule / kelvin / kilogram".
#pragma once

#include <string>

#include "core/base/unit.h"

namespace covaria {

/// Error: a word that is no known unit; Fahrenheit and other scales that Covaria does not have.
Result<Unit> unit_of_pint(const std::string& text);

}  // namespace covaria
