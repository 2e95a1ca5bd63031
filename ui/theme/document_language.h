// The languages of documents, by the catalogues of the window's texts.
#pragma once

#include "core/project/project.h"
#include "core/text/document_language.h"

namespace covaria::ui {

/// Language of a project's certificate and report, with its numbers; English where its catalogue is not in
/// the program. For any thread.
DocumentLanguage document_language(const Project& project);
/// Language of the window, with the user's numbers.
DocumentLanguage language_of_window();

}  // namespace covaria::ui
