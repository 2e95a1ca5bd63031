// The folder that a command writes to.
#pragma once

#include <filesystem>

#include "core/base/error.h"

namespace covaria {

/// Makes the folder (and its parents); removes what a killed run has left unfinished in it. Error{io} in
/// words.
Result<void> make_output_folder(const std::filesystem::path& folder);

}  // namespace covaria
