// The languages of documents, by the catalogues of the window's texts.
#pragma once

#include "core/project/project.h"
#include "core/text/document_language.h"

namespace covaria::ui {

/// That of a project's certificate and report, with its numbers; English where its catalogue is not in the
/// program. For any thread.
DocumentLanguage document_language(const Project& project);
/// That of the window.
DocumentLanguage language_of_window();

}  // namespace covaria::ui
