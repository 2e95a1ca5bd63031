// Set-ups in project files: JSON to Setup by a schema, and back to canonical text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/project/json_writer.h"
#include "core/project/object_reader.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// Where the rows of a table came from, for problems found later.
struct CsvOrigin {
    std::string path;  ///< of the table: "/assets/0/setup/observations"
    std::string file;
    std::vector<int> lines;  ///< per row
};

struct ReadContext {
    std::filesystem::path directory;  ///< where CSV files are looked for
    Problems& problems;
    std::vector<CsvOrigin> csv = {};
};

/// Reports under `path` what cannot be read; ranges and required fields are check_setup's matter.
Setup setup_from_json(const Json& value, const SetupSchema& schema, const std::string& path,
                      ReadContext& context);

void write_setup(JsonWriter& out, const Setup& setup, const SetupSchema& schema);
/// {"value": 0.7, "unit": "K"} on one line.
void write_quantity(JsonWriter& out, const Quantity& quantity);

}  // namespace covaria
