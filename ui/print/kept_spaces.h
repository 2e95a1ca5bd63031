// Spaces at which no line breaks: between a number and its unit, around "=", after an abbreviation.
#pragma once

#include <QString>

namespace covaria::ui {

/// The text, of the same length, with U+00A0 for each of those spaces.
QString with_kept_spaces(const QString& text);

}  // namespace covaria::ui
