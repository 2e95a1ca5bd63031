// Remedies of problems, put into effect.
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria {

/// The project with the remedy's values in their places, which are those in the project ("/analyses/0/setup/
/// ..."). A table that is read from a file is taken into the project. Error: a place leads nowhere.
Result<Project> mended(const Project& project, const Remedy& remedy);

}  // namespace covaria
