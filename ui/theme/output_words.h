// The name of an output where one is chosen: "x, TCP".
#pragma once

#include <string>

#include "core/base/name.h"
#include "core/text/text.h"

namespace covaria::ui {

/// Symbol of an output, and its group in the language of the window where it has one.
Text output_words(const std::string& symbol, const Name& group);

}  // namespace covaria::ui
