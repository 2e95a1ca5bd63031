// The date of today where the program runs.
#pragma once

#include <string>

namespace covaria {

/// The local date by ISO 8601: "2026-11-28".
std::string today();

}  // namespace covaria
