// The section of project files that says how results are stated.
#pragma once

#include "core/project/json_writer.h"
#include "core/project/object_reader.h"
#include "core/project/project_results.h"

namespace covaria {

ProjectResults project_results_from_json(const Json& value, const std::string& path, Problems& problems);
/// Writes results that state something as an object on its own lines.
void write_project_results(JsonWriter& out, const ProjectResults& results);

}  // namespace covaria
