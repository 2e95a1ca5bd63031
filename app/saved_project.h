// A project saved where its CSV files may not be.
#pragma once

#include <filesystem>

#include "core/project/project.h"

namespace covaria {

/// Saves a project; in another folder than the one that its CSV files lie in, their tables stand in it.
Result<void> save_with_tables(Project project, const std::filesystem::path& file);

}  // namespace covaria
