// Files that a project names, and what links beside it lead to.
#pragma once

#include <filesystem>

namespace covaria {

/// `name` says that it lies in `folder`, and a link on its way leads elsewhere. What is told to be beside a
/// project is embedded in its reports, so that nothing else of the machine may be reached by it.
bool is_led_out_of(const std::filesystem::path& folder, const std::filesystem::path& name);

}  // namespace covaria
