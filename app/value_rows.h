// A table of values for `run --set-from`: a row is a run with its values in place of the project's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

struct ValueRow {
    std::string name;                 ///< name of its run: a serial number
    std::size_t number = 0;           ///< number of the row below the head, from 1
    int line = 0;                     ///< its line in the file
    std::vector<std::string> values;  ///< in the form of `--set`
};

/// Columns whose head begins with '/' give values, empty cells none; the first other column gives the names,
/// and there must be one. Errors have file and line.
Result<std::vector<ValueRow>> read_value_rows(const std::filesystem::path& file);

}  // namespace covaria
