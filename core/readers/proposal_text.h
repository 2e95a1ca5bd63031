// The proposals of a reader as text: for the terminal and the import dialog.
#pragma once

#include <string>

#include "core/readers/reader.h"
#include "core/text/document_language.h"

namespace covaria {

/// The text of proposals: what was found, with the first rows of the tables if `with_tables`, and what is not
/// taken over.
std::string text_of(const Reader& reader, const Proposals& proposals, bool with_tables,
                    const DocumentLanguage& in = {});
std::string list_of_readers();

}  // namespace covaria
