// Reading whole files, with the system's reason when it fails.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace covaria {

/// Error{not_found} or Error{io}: the message names the file and the system's reason.
Result<std::string> read_file(const std::filesystem::path& file);

}  // namespace covaria
