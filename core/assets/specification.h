// A figure from a data sheet: a standard uncertainty, or a limit (MPE) with an assumed distribution.
#pragma once

#include <string>

#include "core/model/setup_schema.h"
#include "core/quantity/distribution.h"

namespace covaria {

/// `meaning`: standard uncertainty, expanded (k = 2), or limit with rectangular or triangular distribution.
FieldSpec meaning_field(const std::string& section);

/// The distribution of a deviation for which the data sheet says `figure` with that meaning.
Distribution specified_distribution(const std::string& meaning, double figure);
std::string meaning_words(const std::string& meaning);

}  // namespace covaria
