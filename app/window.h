// The program as a window.
#pragma once

#include <string>

namespace covaria {

/// Opens the window with a project (or, with an empty name, the start page) and runs it until it is closed.
int run_window(const std::string& file);

}  // namespace covaria
