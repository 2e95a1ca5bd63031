// Reading and writing *.covaria files: one JSON file, UTF-8, fixed key order, one table row a line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/file_io.h"
#include "core/project/project.h"
#include "core/project/set_values.h"

namespace covaria {

inline constexpr int project_schema_version = 1;

struct LoadedProject {
    Project project;    ///< meaningful only if `problems` has no errors
    Problems problems;  ///< with JSON path, file and line where known
};

/// Bytes; neither read nor written are larger ones. What is made of a project's text takes up to fifty times
/// its size.
inline constexpr std::size_t largest_project = 40'000'000;

/// Reads, migrates older versions, reads referenced CSV files, checks everything (setups against schemas,
/// units, references, edits, correlations, options). An unknown key, a wrong unit, a missing reference, a
/// newer version: an error.
/// `values`: read as if they stood in the file; problems of the file have no lines then.
LoadedProject load_project(const std::filesystem::path& file, const std::vector<ValueAt>& values = {});
/// The same from text; `directory` is where CSV files are looked for; `name` stands for the file in messages.
LoadedProject parse_project(const std::string& text, const std::filesystem::path& directory,
                            const std::string& name);

/// Where the CSV files of a project file are looked for: beside it, or beside what a link leads to.
std::filesystem::path project_folder(const std::filesystem::path& file);

/// Canonical text: loading and writing a canonical file gives the same bytes.
std::string project_text(const Project& project);
/// Atomic: temporary file in the same folder, flush, rename. Error{io} leaves the old file as it was.
Result<void> save_project(const Project& project, const std::filesystem::path& file);

/// 16 hexadecimal digits over everything that influences numbers (not titles and notes), CSV contents
/// included.
std::string fingerprint(Project project);

}  // namespace covaria
