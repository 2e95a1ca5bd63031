// Places of the files shipped with the program: examples, help pages, the instrument library.
#pragma once

#include <filesystem>

namespace covaria {

/// Folder that holds `projects/` and `resources/`: beside an installed program (PREFIX/share/covaria), in the
/// source tree for a program run from its build folder, or $COVARIA_DATA_DIR.
std::filesystem::path data_directory();

}  // namespace covaria
