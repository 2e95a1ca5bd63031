// Words for what a field takes: for the command line and the pages of help.
#pragma once

#include <string>

#include "core/setup/setup_schema.h"

namespace covaria {

const char* kind_words(FieldKind kind);
/// "0.5 mm", "true"; empty for tables and for nothing.
std::string value_words(const SetupValue& value);
/// "[0, 1)" in the unit; empty: everything is allowed.
std::string range_words(const Range& range, const Unit& unit);

}  // namespace covaria
