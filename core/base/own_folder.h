// Files that a project names, and what links beside it lead to.
#pragma once

#include <filesystem>

namespace covaria {

/// Whether `name`, which lies in `folder`, is led out of it by a link on its way. Files beside a project are
/// embedded in its reports, so that nothing else of the machine may be reached by them.
bool is_led_out_of(const std::filesystem::path& folder, const std::filesystem::path& name);

}  // namespace covaria
