// Units that a file does not state: taken as people say, else as usual, and listed.
#pragma once

#include <string>

#include "core/readers/reader.h"

namespace covaria {

/// The unit that is stated for `key`, else `otherwise`; `proposals` lists it.
Unit unstated_unit(const ReadChoice& choice, const std::string& key, const std::string& title,
                   const Unit& otherwise, Proposals& proposals);

/// Refuses a unit stated for something that the file does not have, or states itself. Error{usage}.
Result<void> check_stated_units(const ReadChoice& choice, const Proposals& proposals);

}  // namespace covaria
