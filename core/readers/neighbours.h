// Files beside the one that is read, which it names: a network in two files, parts that a file includes.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

struct Neighbours {
    /// The text of a file by its name relative to the folder; empty where nothing is beside the file that is
    /// read. Error: it must lie in the folder, a link leads out of it, it cannot be read.
    std::function<Result<std::string>(const std::string& name)> read = {};
    std::vector<std::string> names = {};  ///< files of the folder, sorted; not those in its folders

    static constexpr std::size_t most_names = 10'000;
};

/// What is beside a file. Files are read when they are asked for, as those that a project names: within the
/// folder, not through links that lead out of it, up to `largest_file` bytes.
Neighbours neighbours_of(const std::filesystem::path& file);

}  // namespace covaria
