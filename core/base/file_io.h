// Reading a file whole; replacing one so that a crash leaves the old or the new.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace covaria {

/// Size, in bytes, above which files are refused before any of them is read. What is made of a file takes a
/// few times its size.
inline constexpr std::uintmax_t largest_file = 200'000'000;

/// Error{not_found} or Error{io}: the message names the file and the reason: the system's, more than
/// `largest_file` bytes, or no file but a folder, pipe, device or socket (which is never waited for).
Result<std::string> read_file(const std::filesystem::path& file);

/// Writes a temporary file in the same folder, flushes and renames it. Error{io} leaves the old file as it
/// was. The file that a link names is replaced, not the link; devices and pipes are written to.
Result<void> write_file_atomically(const std::filesystem::path& file, const std::string& bytes);

/// Removes the temporary files in `folder` that were left by processes of this machine that have been killed.
void remove_leftovers(const std::filesystem::path& folder);
/// Removes the temporary files that this process has not finished: before it ends itself. Safe at any moment.
void remove_unfinished_files();

}  // namespace covaria
