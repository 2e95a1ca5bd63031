#include "core/base/resource_path.h"

#include <cstdlib>
#include <system_error>

namespace covaria {

namespace fs = std::filesystem;

fs::path data_directory() {
    if (const char* set = std::getenv("COVARIA_DATA_DIR")) return set;
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path installed = program.parent_path().parent_path() / "share" / "covaria";
    if (!program.empty() && fs::exists(installed / "projects", ignored)) return installed;
    return COVARIA_SOURCE_DATA_DIR;
}

}  // namespace covaria
