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
    Project project;          ///< has a meaning only if `is_project`
    bool is_project = false;  ///< false where the text is no project at all
    /// Problems of reading alone, with JSON path; `locate` adds file and line where known.
    Problems problems;
    std::function<void(Problems&)> locate;
};

/// The most bytes of a project's text; larger ones are neither read nor written, because what is made of the
/// text takes up to fifty times its size.
inline constexpr std::size_t largest_project = 40'000'000;
/// The message about a project of more bytes than that.
Message too_large(std::size_t bytes);

/// Reads a project, brings older versions up to date, and reads the CSV files that it refers to; an unknown
/// key or a newer version is an error. The project is checked when it is made (core/made/load_project.h).
/// `directory` is where CSV files are looked for; `name` stands for the file in messages.
ReadProject read_project(const std::string& text, const std::filesystem::path& directory,
                         const std::string& name);

/// The folder in which the CSV files of a project file are looked for: beside it, or beside the file that a
/// link leads to.
std::filesystem::path project_folder(const std::filesystem::path& file);

/// The canonical text of a project: loading and writing a canonical file gives the same bytes.
std::string project_text(const Project& project);
/// Saves a project at once or not at all: temporary file in the same folder, flush, rename. Error{io} leaves
/// the old file as it was.
Result<void> save_project(const Project& project, const std::filesystem::path& file);

/// The fingerprint of a project: 16 hexadecimal digits over everything that influences numbers (not titles,
/// notes and the order of assets), CSV contents included.
std::string fingerprint(Project project);
/// Whether nothing that influences numbers differs: whether the fingerprints are the same, without making
/// their texts.
bool same_numbers(Project a, Project b);

}  // namespace covaria
