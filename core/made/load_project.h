// Project files read and made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/made/made_project.h"
#include "core/project/project_file.h"
#include "core/project/set_values.h"

namespace covaria {

struct LoadedProject {
    Project project;            ///< meaningful only if `problems` has no errors
    Problems problems;          ///< have JSON path, file and line where known
    MadeProject::Pointer made;  ///< made of `project`; null where there is no project at all
    /// The project is all that the file says: errors, if any, are of what it is made into (a value that is
    /// missing, an asset that is gone), as they are in work that goes on.
    bool is_whole = false;
};

/// Reads, migrates older versions, reads referenced CSV files, makes and so checks everything (setups against
/// schemas, units, references, edits, correlations, options). An unknown key, a wrong unit, a missing
/// reference, a newer version: an error.
/// `values`: read as if they stood in the file; problems of the file have no lines then.
LoadedProject load_project(const std::filesystem::path& file, const std::vector<ValueAt>& values = {});
/// The same from text; `directory` is where CSV files are looked for; `name` stands for the file in messages.
LoadedProject parse_project(const std::string& text, const std::filesystem::path& directory,
                            const std::string& name);

}  // namespace covaria
