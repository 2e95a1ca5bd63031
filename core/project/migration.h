// Older versions of the project file, brought up step by step: pure functions from JSON to JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace covaria {

/// The document as of `project_schema_version`. Errors (path "/schemaVersion"): no version, or one that this
/// program does not know because it is newer.
Result<nlohmann::ordered_json> migrate_project(nlohmann::ordered_json document);

}  // namespace covaria
