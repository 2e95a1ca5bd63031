// The version of this program, from the one place that states it (CMakeLists.txt).
#pragma once

namespace covaria {

/// "0.2.0".
const char* version();

}  // namespace covaria
