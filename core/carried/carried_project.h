// The project that a report carries, taken out of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/made/load_project.h"
#include "core/pdf/pdf_archive.h"

namespace covaria {

/// "%PDF-" near the beginning, as readers of PDF look for it.
bool is_pdf(std::string_view beginning);

/// Files that a report carries. Errors name the file: it cannot be read, is no PDF, carries no project.
Result<std::vector<AttachedFile>> carried_files(const std::filesystem::path& report);

/// Reads and makes the project of a report as `load_project` does, in a folder of its own that is removed
/// again: its tables stand in it, no file beside it is needed. Problems, with the report as their file: those
/// of `carried_files`; a name that leaves the folder; those of the project.
LoadedProject load_carried(const std::filesystem::path& report);
LoadedProject load_carried(const std::filesystem::path& report, const std::vector<AttachedFile>& files);

}  // namespace covaria
