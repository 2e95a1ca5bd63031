// Files that not everybody may read.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace covaria {

/// Writes a file as `write_file_atomically` does, which at no moment allows more than `mode` (0600).
Result<void> write_file_with_mode(const std::filesystem::path& file, const std::string& bytes, unsigned mode);

}  // namespace covaria
