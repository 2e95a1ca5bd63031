#include "core/base/own_folder.h"

#include <algorithm>
#include <system_error>

namespace covaria {

namespace fs = std::filesystem;

bool is_led_out_of(const fs::path& folder, const fs::path& name) {
    const fs::path relative = name.lexically_normal();
    if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") return false;
    std::error_code failure;
    const fs::path here = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, failure);
    if (failure) return false;
    const fs::path there = fs::weakly_canonical(here / relative, failure);
    if (failure) return false;  // a circle of links: nothing can be read there
    return std::mismatch(here.begin(), here.end(), there.begin(), there.end()).first != here.end();
}

}  // namespace covaria
