// What a reader proposes, as text: for the terminal and the import dialog.
#pragma once

#include <string>

#include "core/readers/reader.h"
#include "core/text/document_language.h"

namespace covaria {

/// What was found, with the first rows of its tables if `with_tables`, and what is not taken over.
std::string text_of(const Reader& reader, const Proposals& proposals, bool with_tables,
                    const DocumentLanguage& in = {});
std::string list_of_readers();

}  // namespace covaria
