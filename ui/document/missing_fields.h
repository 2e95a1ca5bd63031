// Fields that are not given yet: an entry that lacks some is unfinished, not wrong.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria::ui {

/// Whether the problem (path from the root of the project) is that a field of a set-up is empty which must be
/// given, or a line of a text has no end yet, or that nothing is given at all yet, or that a reference leads
/// to an asset or analysis that lacks nothing but such fields.
bool is_missing(const Project& project, const Problems& all, const Problem& problem);

/// The errors of the entry at `entry` ("/analyses/0"): none, only missing fields, or others too.
enum class Lack { nothing, fields, other };
Lack lack_of(const Project& project, const Problems& all, const std::string& entry);

/// The first field to fill, for an entry that lacks fields only: in itself, or in what it refers to. `title`
/// is that of the field, `path` leads to it. Empty: nothing is missing.
struct MissingField {
    std::string title, path;
};
std::optional<MissingField> next_missing(const Project& project, const Problems& all,
                                         const std::string& entry);

}  // namespace covaria::ui
