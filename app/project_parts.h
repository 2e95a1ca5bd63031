// The parts of an analysis that every model has (edits of inputs, correlations, options, requirements,
// studies), described from the JSON schema of the project file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

struct ProjectPart {
    std::string name;   ///< its key in the project file: "inputs"
    std::string title;  ///< shown in the list: "edits of input quantities"
};
const std::vector<ProjectPart>& project_parts();

/// Fields, choices, ranges and defaults of a part; empty: there is no such part. Error: the schema file is
/// missing or damaged.
Result<std::optional<std::string>> description_of_part(const std::string& name);
/// The same for programs: the part's own JSON schema, and those that it refers to.
Result<std::optional<std::string>> description_of_part_json(const std::string& name);

}  // namespace covaria
