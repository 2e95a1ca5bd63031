// Studies in project files.
#pragma once

#include "core/project/json_writer.h"
#include "core/project/object_reader.h"
#include "core/project/study.h"

namespace covaria {

Study study_from_json(const Json& value, const std::string& path, Problems& problems);
void write_study(JsonWriter& out, const Study& study);

}  // namespace covaria
