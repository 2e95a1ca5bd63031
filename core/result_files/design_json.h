// The result of a design as a file for scripts.
#pragma once

#include <string>

#include "core/result/design_result.h"

namespace covaria {

/// design.json: everything, numbers of outputs in their units.
std::string design_json(const DesignResult& result);

}  // namespace covaria
