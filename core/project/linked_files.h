// The CSV files a project refers to.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/project/project.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// Calls `visit` for every table that was read from a file.
void for_linked_tables(Project& project, const std::function<void(SetupTable&, const FieldSpec&)>& visit);

/// Names as written in the project, each once.
std::vector<std::string> linked_files(const Project& project);

/// Puts all tables into the project itself: it needs no file beside it any more.
void unlink_tables(Project& project);

}  // namespace covaria
