// Remedies of problems, put into effect.
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria {

/// The project with the remedy's values in their places, which are those in the project ("/analyses/0/setup/
/// ..."). Error: one of them is in a table that is read from a file.
Result<Project> mended(const Project& project, const Remedy& remedy);

}  // namespace covaria
