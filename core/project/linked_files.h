// The CSV files a project refers to.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/project/project.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// Calls `visit` for every table that was read from a file.
void for_linked_tables(Project& project, const std::function<void(SetupTable&, const FieldSpec&)>& visit);

/// Names of the linked files as written in the project, each once.
std::vector<std::string> linked_files(const Project& project);

/// A file that a text of a set-up names (FieldSpec::file_ending).
struct NamedFile {
    std::string name;  ///< name as written
    std::filesystem::path path;
};
/// Named files of one set-up, in the order of its schema; blank names are left out.
std::vector<NamedFile> named_files(const Project& project, const SetupSchema& schema, const Setup& setup);
/// Names of files that influence no number, each once: those that set-ups name, and the logo of the
/// certificate.
std::vector<std::string> context_files(const Project& project);

/// Puts all tables into the project itself, so that it needs no file beside it any more.
void unlink_tables(Project& project);

}  // namespace covaria
