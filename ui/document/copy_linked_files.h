// Carrying the CSV files of a project along to another folder.
#pragma once

#include <filesystem>

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria::ui {

/// Copies those with relative names from the project's folder to `folder`, unless they are there already.
/// Error{io} names the file that could not be copied.
Result<void> copy_linked_files(const Project& project, const std::filesystem::path& folder);

}  // namespace covaria::ui
