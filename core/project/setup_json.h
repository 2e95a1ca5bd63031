// Set-ups in project files: JSON to Setup by a schema, and back to canonical text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/project/json_writer.h"
#include "core/project/object_reader.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// The places that the rows of a table came from, for problems found later.
struct CsvOrigin {
    std::string path;  ///< path of the table: "/assets/0/setup/observations"
    std::string file;
    std::vector<int> lines;  ///< line of each row
};

struct ReadContext {
    std::filesystem::path directory;  ///< folder where CSV files are looked for
    Problems& problems;
    std::vector<CsvOrigin> csv = {};
};

/// The set-up that a JSON value states. Values that cannot be read are reported under `path`; ranges and
/// required fields are check_setup's matter.
Setup setup_from_json(const Json& value, const SetupSchema& schema, const std::string& path,
                      ReadContext& context);

void write_setup(JsonWriter& out, const Setup& setup, const SetupSchema& schema);
/// Writes a quantity as {"value": 0.7, "unit": "K"} on one line.
void write_quantity(JsonWriter& out, const Quantity& quantity);

}  // namespace covaria
