// The review of a project as project files have it.
#pragma once

#include "core/project/json_fields.h"
#include "core/project/review.h"

namespace covaria {

const JsonFields<Review>& review_fields();

}  // namespace covaria
