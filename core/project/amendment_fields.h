// The statements of a replaced certificate as project files have them.
#pragma once

#include "core/project/amendment.h"
#include "core/project/json_fields.h"

namespace covaria {

const JsonFields<Amendment>& amendment_fields();

}  // namespace covaria
