// A text in lines.
#pragma once

#include <functional>
#include <vector>

#include "core/text/text.h"

namespace covaria {

/// Broken at spaces into lines that fit, where words allow it.
std::vector<Text> wrapped(const Text& text, const std::function<bool(const Text&)>& fits);

}  // namespace covaria
