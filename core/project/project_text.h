// The canonical text of a project, and whether it holds everything.
#pragma once

#include <string>

#include "core/project/project.h"

namespace covaria {

struct WrittenProject {
    std::string text;
    bool complete = true;  ///< false where a number was not finite, or a set-up has fields without a schema
};

WrittenProject write_project(const Project& project);

}  // namespace covaria
