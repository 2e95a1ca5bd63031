// Files that not everybody may read.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace covaria {

/// As `write_file_atomically`, and nobody may do with it what `mode` (0600) does not allow, at any moment.
Result<void> write_file_with_mode(const std::filesystem::path& file, const std::string& bytes, unsigned mode);

}  // namespace covaria
