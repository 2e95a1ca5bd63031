// A figure from a data sheet: a standard uncertainty, or a limit (MPE) with an assumed distribution.
#pragma once

#include <string>

#include "core/quantity/distribution.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// `meaning`: standard uncertainty, expanded (k = 2), or limit with rectangular or triangular distribution.
FieldSpec meaning_field(const std::string& section);

/// The distribution of a deviation for which the data sheet says `figure` with that meaning.
Distribution specified_distribution(const std::string& meaning, double figure);
Message meaning_words(const std::string& meaning);

/// The shape of what is stated as a standard uncertainty: a field, or a column that may be left empty.
FieldSpec distribution_field(const std::string& key, const std::string& of_what, const std::string& section);
ColumnSpec distribution_column();
/// The distribution about 0 of that shape ("normal", "rectangular" ...; empty: normal) and standard
/// uncertainty.
Distribution distribution_of_shape(const std::string& shape, double u);

}  // namespace covaria
