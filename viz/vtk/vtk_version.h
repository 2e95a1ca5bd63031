// Version of the VTK that draws, for the window's About.
#pragma once

#include <string>

namespace covaria {

/// "9.1.0"
std::string vtk_version();

}  // namespace covaria
