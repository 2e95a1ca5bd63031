// Evaluation options in project files: only what is not default is written.
#pragma once

#include <string>

#include "core/project/json_writer.h"
#include "core/project/object_reader.h"
#include "core/propagation/options.h"

namespace covaria {

EvaluationOptions options_from_json(const Json& value, const std::string& path, Problems& problems);
/// An object on its own lines; the options are not all default.
void write_options(JsonWriter& out, const EvaluationOptions& options);

}  // namespace covaria
