// Designs in project files.
#pragma once

#include "core/project/design.h"
#include "core/project/json_writer.h"
#include "core/project/object_reader.h"

namespace covaria {

/// What the objective is called in files.
const char* key_of(DesignObjective objective);
const char* key_of(PriceLaw law);

Design design_from_json(const Json& value, const std::string& path, Problems& problems);
void write_design(JsonWriter& out, const Design& design);

}  // namespace covaria
