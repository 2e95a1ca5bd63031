// Reading and writing *.covaria files: one JSON file, UTF-8, fixed key order, one table row a line.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/base/file_io.h"
#include "core/project/project.h"

namespace covaria {

inline constexpr int project_schema_version = 2;

/// A project as its text says it.
struct ReadProject {
    Project project;          ///< meaningful only if `is_project`
    bool is_project = false;  ///< else the text is no project at all
    Problems problems;        ///< of reading alone, with JSON path; `locate` adds file and line where known
    std::function<void(Problems&)> locate;
};

/// Bytes; neither read nor written are larger ones. What is made of a project's text takes up to fifty times
/// its size.
inline constexpr std::size_t largest_project = 40'000'000;
/// What is wrong with a project of more.
Message too_large(std::size_t bytes);

/// Reads, migrates older versions, reads referenced CSV files; an unknown key, a newer version is an error.
/// What is read is checked when it is made (core/made/load_project.h). `directory` is where CSV files are
/// looked for; `name` stands for the file in messages.
ReadProject read_project(const std::string& text, const std::filesystem::path& directory,
                         const std::string& name);

/// Where the CSV files of a project file are looked for: beside it, or beside what a link leads to.
std::filesystem::path project_folder(const std::filesystem::path& file);

/// Canonical text: loading and writing a canonical file gives the same bytes.
std::string project_text(const Project& project);
/// Atomic: temporary file in the same folder, flush, rename. Error{io} leaves the old file as it was.
Result<void> save_project(const Project& project, const std::filesystem::path& file);

/// 16 hexadecimal digits over everything that influences numbers (not titles, notes and the order of assets),
/// CSV contents included.
std::string fingerprint(Project project);
/// Nothing that influences numbers differs: as fingerprints that are the same, without their texts.
bool same_numbers(Project a, Project b);

}  // namespace covaria
