// Older versions of the project file, brought up step by step: pure functions from JSON to JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// Entries that stand elsewhere than in the file that was read, by JSON pointers.
struct MovedEntries {
    struct Move {
        std::string to, from;
    };
    std::vector<Move> moves = {};

    std::string place_in_file(const std::string& place) const;
};

struct MigratedProject {
    nlohmann::ordered_json document;
    MovedEntries moved = {};
};

/// The document brought up to `project_schema_version`. Errors (path "/schemaVersion"): no version, or one
/// that this program does not know because it is newer.
Result<MigratedProject> migrate_project(nlohmann::ordered_json document);

}  // namespace covaria
