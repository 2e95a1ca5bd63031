// The fonts of letters in pictures, as files: VTK knows nothing of those that the system offers.
#pragma once

#include <string>
#include <string_view>

#include "core/text/document_language.h"

namespace covaria {

/// Liberation Sans or DejaVu Sans; one with Chinese, Japanese and Korean letters where the text has any.
/// Empty where none is installed.
const std::string& font_file_for(std::string_view text, bool bold);

/// The language `wanted`; where no font has its letters, English with its form of numbers.
DocumentLanguage scene_language(const DocumentLanguage& wanted);

}  // namespace covaria
