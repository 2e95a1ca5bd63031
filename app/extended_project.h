// The project that an import adds to.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria {

/// The project in the file, or a new one of that title where there is none. Prints the problems of the file.
/// Error: it has errors.
Result<Project> project_to_extend(const std::string& file, const std::string& title);

}  // namespace covaria
